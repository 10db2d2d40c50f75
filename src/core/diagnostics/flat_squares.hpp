// Straight-edged quadrilaterals in the plane, many at once: what QualityMeter asks of the cells that most
// meshes have, made quick. In such a cell x is bilinear in (s, t), its Jacobian det dx/d(s, t) linear:
//
//   x = x0 + s a + t b + s t d,     J = a x b + s (a x d) + t (d x b)
//
// so J, and its ratio to that of the computational cell, is smallest and largest at corners.
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
    static constexpr std::size_t batch = 16; ///< cells that are measured at once

    static bool fits(const Mesh& mesh) {
        return mesh.kind == CellKind{CellShape::quadrilateral, 1} && mesh.space_dimension == 2;
    }
    /// Gauss points per direction for the integral of the monitor.
    explicit FlatSquares(int points) : rule_(gauss_legendre(points)) {}

    using Lane = std::array<double, batch>; ///< one number of every cell
    struct Measured {
        Lane mass;              ///< integral of the monitor over the cell
        Lane smallest, largest; ///< Jacobian, over the corners
    };
    struct Workspace {
        Points points; ///< of the quadrature: of the first point in all cells, of the second, ...
        std::vector<double> monitor;
    };
    /// Cells begin .. end of the mesh, at most `batch`, with their nodes at x.
    Measured measure(const Mesh& mesh, std::size_t begin, std::size_t end, const Points& x,
                     const Monitor& monitor, Workspace& workspace) const;

  private:
    LineQuadrature rule_;
};

} // namespace gaspard
