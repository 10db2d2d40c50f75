// Boxes with sides along the axes.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

namespace gaspard GASPARD_API {

struct Box {
    Vec3 low, high;
    Vec3 centre() const { return 0.5 * (low + high); }
    /// Length of the diagonal.
    double size() const { return norm(high - low); }
    friend bool operator==(const Box&, const Box&) = default;
};
/// The smallest box around all finite points; a box at the origin if there is none.
Box bounding_box(const Points& points);
Box merge(const Box& a, const Box& b);
/// The length of the longest side.
double longest_side(const Box& box);

} // namespace GASPARD_API
