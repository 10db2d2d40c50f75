// Points and tangents of a quadrilateral or hexahedron of any order on a grid of reference points, summed one
// direction after the other: for order k and m points per direction about 3 m (k + 1) (m + k + 1) products
// instead of 3 m^2 (k + 1)^2, of a hexahedron about 4 m^3 (k + 1) instead of 4 m^3 (k + 1)^3.
#pragma once

#include "core/mesh/cell_measure.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard {

struct PlaceInCell {
    Vec3 x;
    Tangents tangents{};
};

class TensorCell {
  public:
    /// The grid is `at` x `at` (x `at`), s fastest. `kind`: a quadrilateral or a hexahedron.
    TensorCell(CellKind kind, std::span<const double> at);

    struct Workspace {
        std::vector<Vec3> sorted;         ///< nodes relative to the first, row by row
        std::vector<Vec3> values, slopes; ///< after the sums along s
        /// Of a hexahedron, after those along t: values, and derivatives by s and t.
        std::array<std::vector<Vec3>, 3> planes;
    };
    /// `nodes` of the cell in their order; one entry of `out` per grid point.
    void evaluate(std::span<const Vec3> nodes, std::span<PlaceInCell> out, Workspace& workspace) const;
    std::size_t points() const { return points_; } ///< per direction

  private:
    void sum_along_s(std::span<const Vec3> nodes, Workspace& workspace) const;
    void evaluate_square(Vec3 origin, std::span<PlaceInCell> out, const Workspace& workspace) const;
    void evaluate_cube(Vec3 origin, std::span<PlaceInCell> out, Workspace& workspace) const;

    bool cube_;
    std::size_t width_, points_;          ///< nodes and points per direction
    std::vector<std::size_t> place_;      ///< of each node in the rows
    std::vector<double> values_, slopes_; ///< of the Lagrange polynomials, `width_` per point
};

} // namespace gaspard
