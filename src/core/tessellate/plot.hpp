// A plot as plain data: curves over axes. The window and the papers' figures draw it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

struct Curve {
    std::string label;                   ///< empty: no entry in the legend
    std::vector<double> x, y;            ///< of equal length; a NaN in y is a gap
    bool markers = false;                ///< a disc at every point
    std::optional<std::size_t> colour{}; ///< index of a theme colour; default: the curve's
    bool behind = false;                 ///< thinner, and below those that are not
    /// Between its points y is linear in x, and drawn so on logarithmic axes, too; from a point at x = 0 on.
    /// Else points are connected by straight lines on the page.
    bool linear = false;
    std::string name{}; ///< what a read-out calls a curve without a label
};

struct Axis {
    std::string label;
    bool logarithmic = false;
    std::optional<double> low{}, high{}; ///< visible range, low < high; default: all values
    bool reversed = false;               ///< small values are at the right or at the top
    std::string before{};                ///< what labels begin with: "1 − " before a distance from 1
    bool whole = false;                  ///< counts, such as iterations: whole numbers, none below 0
};

/// A thin vertical line that marks an event.
struct PlotMark {
    double x = 0;
    std::string label;   ///< the event
    bool handle = false; ///< in the window it can be dragged along x: a knob and the value say so
};

/// A dashed horizontal line at a value that curves are compared with, such as a tolerance. The range of the
/// axis includes it.
struct PlotLevel {
    double y = 0;
    std::string label;
};

/// Places on the x axis, each a short stroke in a row below the curves.
struct PlotRow {
    std::vector<double> x;
    std::size_t colour = 0; ///< index of a theme colour
};

struct Plot {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    std::vector<PlotMark> marks{};
    std::vector<PlotRow> rows{};
    std::vector<PlotLevel> levels{};
};

} // namespace gaspard
