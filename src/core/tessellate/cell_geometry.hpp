// Measures and Jacobians of a mesh's cells from the positions of their nodes alone. Cheaper than a
// measurement (core/diagnostics), so that an image can be coloured in between.
#pragma once

#include "core/mesh/tensor_cell.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gaspard {

/// The radius of the sphere around the origin on which all nodes of a surface lie; 0 if there is none.
double radius_of_ball(const Mesh& mesh);

/// Indices of the cells whose Jacobian is <= 0 or NaN, ascending.
std::vector<std::uint32_t> tangled_cells(std::span<const double> jacobians);

class CellGeometry {
  public:
    explicit CellGeometry(std::shared_ptr<const Mesh> mesh);

    /// Length, area or volume of every cell for nodes at `x`; negative if the cell is reversed.
    std::vector<double> measures(const Points& x) const;
    /// Minimum over the nodes of det dx/dxi, for every cell. On lines and surfaces in space it is negative if
    /// the cell faces away from the computational cell; on a sphere, where cells move around it, if one of
    /// the two faces outward and the other inward. Nodes at which the computational cell is degenerate are
    /// left out.
    std::vector<double> jacobians(const Points& x) const;
    /// Indices of the cells whose Jacobian is <= 0 or NaN, ascending; faster than
    /// tangled_cells(jacobians(x)).
    std::vector<std::uint32_t> tangled(const Points& x) const;

  private:
    struct Sample {
        std::vector<double> values;  ///< of the shape functions
        std::vector<Vec3> gradients; ///< of the shape functions
        double weight = 0;
    };

    /// At the nodes or at the quadrature points of a cell. Of a surface on a ball the third is the position.
    struct Work {
        std::vector<Vec3> nodes;
        std::vector<PlaceInCell> places;
        TensorCell::Workspace tensor;
    };
    void find_tangents(std::size_t cell, const Points& x, bool at_nodes, std::vector<Tangents>& out,
                       Work& work) const;
    Tangents tangents(std::span<const std::int32_t> cell, const Points& x, const Sample& sample) const;
    double signed_measure(const Tangents& of, const Tangents& reference) const;
    bool straight_in_the_plane() const;
    std::vector<std::uint32_t> tangled_in_the_plane(const Points& x) const;

    std::shared_ptr<const Mesh> mesh_;
    int dimension_;
    bool on_ball_;
    std::vector<Sample> nodes_, quadrature_;
    std::optional<TensorCell> node_cell_, quadrature_cell_; ///< of hexahedra
    bool turns_left_ = false; ///< straight-edged planar mesh whose corners all turn left
};

} // namespace gaspard
