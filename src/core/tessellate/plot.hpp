// A plot as plain data: curves over axes. The window's plots and the papers' figures are drawn from it.
#pragma once

#include <string>
#include <vector>

namespace gaspard {

struct Curve {
    std::string label;
    std::vector<double> x, y; ///< of equal length; a NaN in y is a gap
    bool markers = false;     ///< a disc on every point
};

struct Axis {
    std::string label;
    bool logarithmic = false;
};

struct Plot {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
};

} // namespace gaspard
