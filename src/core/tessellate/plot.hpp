// A plot as plain data: curves over axes. The window's plots and the papers' figures are drawn from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

struct Curve {
    std::string label;        ///< empty: no entry in the legend
    std::vector<double> x, y; ///< of equal length; a NaN in y is a gap
    bool markers = false;     ///< a disc on every point
    std::optional<std::size_t>
        colour{}; ///< which of a theme's curve colours; empty: by its place in the plot
};

struct Axis {
    std::string label;
    bool logarithmic = false;
    std::optional<double> low{}, high{}; ///< what is to be seen, low < high; empty: all there is
};

/// A thin vertical line where something happened.
struct PlotMark {
    double x = 0;
    std::string label; ///< what happened
};

struct Plot {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    std::vector<PlotMark> marks{};
};

} // namespace gaspard
