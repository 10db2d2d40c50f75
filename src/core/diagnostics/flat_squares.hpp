// Batched measurement of straight-edged quadrilaterals in the plane, the most common cells, for QualityMeter.
// On such a cell x is bilinear in the reference coordinates (s, t), and its Jacobian J = det dx/d(s, t)
// linear:
//
//   x = x0 + s a + t b + s t d
//
//   J = a x b + s (a x d) + t (d x b)
//
// so that J and its ratio to that of the computational cell take their extrema at the corners.
#pragma once

#include "core/fem/gauss.hpp"
#include "core/mesh/mesh.hpp"
#include "core/monitor/monitor.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard {

class FlatSquares {
  public:
    static constexpr std::size_t batch = 16; ///< cells per batch

    static bool fits(const Mesh& mesh) {
        return mesh.kind == CellKind{CellShape::quadrilateral, 1} && mesh.space_dimension == 2;
    }
    /// `points`: Gauss points per direction for the integral of the monitor.
    explicit FlatSquares(int points) : rule_(gauss_legendre(points)) {}

    using Lane = std::array<double, batch>; ///< one number per cell
    struct Measured {
        Lane mass;              ///< integral of the monitor over the cell
        Lane smallest, largest; ///< extrema of the Jacobian over the corners
    };
    struct Workspace {
        Points points; ///< quadrature points, those of each point in all cells contiguous
        std::vector<double> monitor;
    };
    /// Measures cells begin .. end (at most `batch`) with nodes at x; no mass if the monitor is null.
    Measured measure(const Mesh& mesh, std::size_t begin, std::size_t end, const Points& x,
                     const Monitor* monitor, Workspace& workspace) const;

  private:
    LineQuadrature rule_;
};

} // namespace gaspard
