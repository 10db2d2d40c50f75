// A function of a nonvariational space at points of any other mesh of the same domain:
//
//   u(x) = sum_i l_i (u_i + G_i . d_i + d_i^T H_i d_i / 2),   d_i = x - x_i
//
// over the corners of the triangle of x, l_i its barycentric coordinates. Unlike u itself, this has no kinks
// of order h at edges, which recovered Hessians on another mesh would see.
#pragma once

#include "core/transport/nonvariational_space.hpp"

#include <span>
#include <vector>

namespace gaspard {

/// Points outside the mesh get the continuation from the nearest triangle.
std::vector<double> recovered_values(const NonvariationalSpace& space, std::span<const double> u,
                                     const Points& x);

} // namespace gaspard
