// A convex quadrilateral as the image of the unit square,
//
//   x(s, t) = (1 - s)(1 - t) c_1 + s (1 - t) c_2 + s t c_3 + (1 - s) t c_4,   corners c_k anticlockwise,
//
// divided into N x N parts of two triangles each, which right diagonals (from (0, 0) to (1, 1)) separate.
// Node (i, j) has number j (N + 1) + i and xi = x(i/N, j/N).
#pragma once

#include "core/mesh/discretisation.hpp"
#include "core/mesh/domain_type.hpp"

#include <array>
#include <memory>

namespace gaspard {

using Corners = std::array<Vec3, 4>;

class QuadrilateralDomain final : public Discretisation {
  public:
    QuadrilateralDomain(const Corners& corners, int cells);

    std::shared_ptr<const Mesh> mesh() const override { return mesh_; }
    std::shared_ptr<const Points> control_points() const override { return corner_points_; }
    std::size_t unknowns() const override;
    const Corners& corners() const { return corners_; }
    int cells() const { return cells_; } ///< N
    /// The positions of points (s, t) of the unit square.
    Points positions(const Points& parameters) const;
    /// The inverse of positions(). Requires has_vertical_sides().
    Points parameters_at(const Points& positions) const;
    /// Whether the left and the right side are vertical.
    bool has_vertical_sides() const;

  private:
    Corners corners_;
    int cells_;
    std::shared_ptr<const Points> corner_points_;
    std::shared_ptr<const Mesh> mesh_;
};

DomainType quadrilateral_domain();
/// Throws InputError if the quadrilateral is not convex, or its corners are not anticlockwise.
std::shared_ptr<const QuadrilateralDomain> make_quadrilateral(const Values& values);

/// The values at (n + 1)^2 nodes of a grid on the unit square, bilinear between the nodes of another one.
Points resampled_grid(const Points& from, int from_cells, int cells);

} // namespace gaspard
