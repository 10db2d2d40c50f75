// How good a physical mesh is, from its cells and the monitor alone, whatever method moved it.
//
//   M_i = (integral of m over physical cell i) / (measure of computational cell i)         McRae et al. (5.2)
//   equidistribution = standard deviation of the M_i / mean of the M_i
//   Jacobian = det dx/dxi of the map from computational to physical cell, at sampled points, corners included
//   A cell is tangled if its Jacobian is <= 0 at any sampled point.
#pragma once

#include "core/mesh/mesh.hpp"
#include "core/monitor/monitor.hpp"

#include <vector>

namespace gaspard {

struct MeshQuality {
    double equidistribution = 0;
    double min_jacobian = 0;
    double max_jacobian = 0;
    std::size_t tangled_cells = 0;
    std::vector<double> cell_mass;     ///< M_i
    std::vector<double> cell_jacobian; ///< smallest Jacobian over the sampled points, per cell
};

/// Measures a mesh; holds the reference quadrature and the computational measures, and room to work in.
class QualityMeter {
  public:
    /// `points` Gauss points per direction for the integral of m.
    explicit QualityMeter(std::shared_ptr<const Mesh> mesh, int points = 6);
    const MeshQuality& measure(const Points& x, const Monitor& monitor);

  private:
    struct Sample {
        std::vector<double> values;
        std::vector<Vec3> gradients;
        double weight = 0;
    };
    double jacobian(std::span<const std::int32_t> cell, const Points& x, const Sample& sample) const;

    std::shared_ptr<const Mesh> mesh_;
    std::vector<Sample> quadrature_;
    std::vector<Sample>
        samples_; ///< where the sign of the Jacobian is looked at: nodes and quadrature points
    std::vector<double> reference_; ///< det d xi / d(reference), per cell and sample
    std::vector<double> measure_;   ///< of the computational cells
    Points points_;
    std::vector<double> monitor_;
    MeshQuality quality_;
};

} // namespace gaspard
