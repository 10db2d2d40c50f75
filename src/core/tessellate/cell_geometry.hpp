// What can be told of a mesh's cells from the positions of their nodes alone: how large they are, and how
// they are stretched. Cheap beside a measurement (core/diagnostics), so that a picture can be coloured in
// between.
#pragma once

#include "core/mesh/cell_measure.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// The radius of the sphere around the origin that all nodes of a surface lie on; 0 where there is none.
double radius_of_ball(const Mesh& mesh);

/// Cells with a Jacobian of zero or less, or none at all, in ascending order.
std::vector<std::uint32_t> tangled_cells(std::span<const double> jacobians);

class CellGeometry {
  public:
    explicit CellGeometry(std::shared_ptr<const Mesh> mesh);

    /// Length, area or volume of every cell for nodes at `x`; negative where it is turned over.
    std::vector<double> measures(const Points& x) const;
    /// det dx/dxi of every cell, the smallest at its nodes. On a line or surface in space it is negative
    /// where the cell faces away from the computational one; on a sphere where one of both faces outward and
    /// the other inward, for cells move around it.
    std::vector<double> jacobians(const Points& x) const;
    /// Cells with such a Jacobian of zero or less, or none at all, in ascending order; faster than to compute
    /// them.
    std::vector<std::uint32_t> tangled(const Points& x) const;

  private:
    struct Sample {
        std::vector<double> values;  ///< of the shape functions
        std::vector<Vec3> gradients; ///< likewise
        double weight = 0;
    };

    /// Of a surface on a ball the third is the position.
    Tangents tangents(std::span<const std::int32_t> cell, const Points& x, const Sample& sample) const;
    double signed_measure(const Tangents& of, const Tangents& reference) const;
    bool straight_in_the_plane() const;
    std::vector<std::uint32_t> tangled_in_the_plane(const Points& x) const;

    std::shared_ptr<const Mesh> mesh_;
    int dimension_;
    bool on_ball_;
    std::vector<Sample> nodes_, quadrature_;
    bool turns_left_ = false; ///< straight in the plane, and all corners of the computational mesh do
};

} // namespace gaspard
