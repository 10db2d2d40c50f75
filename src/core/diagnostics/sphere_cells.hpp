// Cells of a sphere around the origin, straight-edged or curved, eight at once: what QualityMeter asks of
// them.
//
// A cell's Jacobian is the ratio of the areas that the physical and the computational cell give to the same
// piece of the reference cell, negative where the physical cell faces inward.
#pragma once

#include "core/fem/cell_quadrature.hpp"
#include "core/monitor/monitor.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard {

class SphereCellMeter {
  public:
    static constexpr std::size_t batch = 8; ///< cells that are measured at once
    using Lane = std::array<double, batch>; ///< one number of every cell

    /// Gauss points per direction for the integral of the monitor.
    SphereCellMeter(CellKind kind, int points);

    struct Measured {
        Lane mass;              ///< integral of the monitor over the cell
        Lane smallest, largest; ///< Jacobian, over the quadrature's points and the nodes
    };
    struct Workspace {
        Points points; ///< of the quadrature: of the first point in all cells, of the second, ...
        std::vector<double> area, monitor;
    };
    /// Cells begin .. end of the mesh, at most `batch`, with their nodes at x.
    Measured measure(const Mesh& mesh, std::size_t begin, std::size_t end, const Points& x,
                     const Monitor& monitor, Workspace& workspace) const;

  private:
    std::size_t nodes_, quadrature_ = 0;
    std::vector<double> weight_, value_, ds_, dt_; ///< of every sample, the quadrature's first; nodes_ each
};

} // namespace gaspard
