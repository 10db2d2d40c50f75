// Axes of a mesh in the plane: ticks along its left and its bottom side, and the names of the coordinates.
// Lengths are in the units of the drawing, pixels or points.
#pragma once

#include "core/base/box.hpp"
#include "core/mesh/mesh.hpp"
#include "core/tessellate/plot_axis.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gaspard {

/// Whether the coordinates of the nodes are those of a plane that the mesh fills.
bool has_plane_axes(const Mesh& mesh);

struct PlaneAxis {
    std::vector<Tick> ticks; ///< within the range, or beside its ends by less than half a pixel or point
    std::string name;        ///< of the coordinate; empty where there is no room for it
    double name_at = 0;      ///< the coordinate of its middle, between two labels
};

/// An axis that shows `range`, low < high, on `length`. `extent`: how much of the axis a text takes, with the
/// gap to the next; labels and name do not touch. About one label per `spacing`.
PlaneAxis plane_axis(const std::string& name, AxisRange range, double length, double spacing,
                     const std::function<double(const std::string&)>& extent);

/// "x" or "y"; "ξ" or "η" of the computational mesh.
std::string coordinate_name(bool vertical, bool computational);

/// The part of `low` to `high` between the ends of what is seen. Empty, low >= high, if nothing is.
AxisRange seen_range(double low, double high, double low_end, double high_end);

/// The room that labels of the vertical axis of `box` need, of a few widths, so that it seldom changes.
double label_room(const Box& box, const std::function<double(const std::string&)>& width);

} // namespace gaspard
