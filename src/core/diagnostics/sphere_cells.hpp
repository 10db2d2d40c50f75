// Batched measurement of straight-edged or curved cells on a sphere around the origin, for QualityMeter.
//
// The Jacobian of a cell is the ratio of the area elements of the physical and the computational cell over
// the reference cell. It is negative where the physical cell faces inward.
#pragma once

#include "core/fem/cell_quadrature.hpp"
#include "core/monitor/monitor.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard {

class SphereCellMeter {
  public:
    static constexpr std::size_t batch = 8; ///< cells per batch
    using Lane = std::array<double, batch>; ///< one number per cell

    /// `points`: Gauss points per direction for the integral of the monitor.
    SphereCellMeter(CellKind kind, int points);

    struct Measured {
        Lane mass;              ///< integral of the monitor over the cell
        Lane smallest, largest; ///< extrema of the Jacobian over quadrature points and nodes
    };
    struct Workspace {
        Points points; ///< quadrature points, those of each point in all cells contiguous
        std::vector<double> area, monitor;
    };
    /// Measures cells begin .. end (at most `batch`) with nodes at x; no mass if the monitor is null.
    Measured measure(const Mesh& mesh, std::size_t begin, std::size_t end, const Points& x,
                     const Monitor* monitor, Workspace& workspace) const;

  private:
    std::size_t nodes_, quadrature_ = 0;
    std::vector<double> weight_, value_, ds_,
        dt_; ///< per sample; quadrature points first
};

} // namespace gaspard
