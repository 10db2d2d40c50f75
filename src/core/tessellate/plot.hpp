// A plot as plain data: curves over axes. The window and the papers' figures draw it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

struct Curve {
    std::string label;                   ///< empty: no entry in the legend
    std::vector<double> x, y;            ///< of equal length; a NaN in y is a gap
    bool markers = false;                ///< a disc at every point
    std::optional<std::size_t> colour{}; ///< index of a theme colour; default: the curve's
};

struct Axis {
    std::string label;
    bool logarithmic = false;
    std::optional<double> low{}, high{}; ///< visible range, low < high; default: all values
};

/// A thin vertical line that marks an event.
struct PlotMark {
    double x = 0;
    std::string label; ///< the event
};

struct Plot {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    std::vector<PlotMark> marks{};
};

} // namespace gaspard
