// A patch or a solid divided into n x n (x n) cells, with the spline spaces for its mesh. Which of them a
// user can choose is in spline_domain.hpp.
#pragma once

#include "core/mesh/discretisation.hpp"
#include "core/spline/patch_map.hpp"
#include "core/spline/spline_forms.hpp"

#include <array>
#include <memory>
#include <vector>

namespace gaspard {

/// Sides of the parameter square or cube, xi_d = 0 and xi_d = 1, that F maps to less than a side: edges of a
/// patch that are one point, such as the tip of a cone, and faces of a solid that are a curve or a point.
template <std::size_t D>
struct CollapsedSides {
    std::array<bool, D> low{}, high{};
};

template <std::size_t D>
class TensorDomain final : public Discretisation {
  public:
    TensorDomain(int degree, std::size_t cells, std::shared_ptr<const TensorMap<D>> map,
                 std::shared_ptr<const Points> control = nullptr,
                 std::shared_ptr<const PatchList> patches = nullptr, std::size_t control_columns = 0);

    /// Quadrilaterals whose order is the degree p, so that they carry Psi exactly and F(Psi) to order p + 1;
    /// (p n + 1)^2 nodes on the patch, xi1 fastest. Likewise hexahedra, whose order is lower where their
    /// nodes would be too many (mesh_order()).
    std::shared_ptr<const Mesh> mesh() const override { return mesh_; }
    std::shared_ptr<const Points> control_points() const override { return control_; }
    std::size_t control_columns() const override { return control_columns_; }
    std::shared_ptr<const PatchList> patches() const override { return patches_; }
    std::shared_ptr<const PatchParameters> parameters() const override { return parameters_; }
    std::shared_ptr<const PatchMap> patch_map() const override;
    std::shared_ptr<const SolidMap> solid_map() const override;
    std::shared_ptr<const SolidShape> solid_shape() const override { return shape_; }
    /// Unknowns of the standard form.
    std::size_t unknowns() const override;

    const std::shared_ptr<const TensorMap<D>>& map() const { return map_; }
    int degree() const { return degree_; }
    std::size_t cells() const { return cells_; }
    const CollapsedSides<D>& collapsed() const { return collapsed_; }
    /// The order of the mesh's cells.
    int mesh_order() const;
    /// Parameters of the nodes along each direction of the parameter square or cube.
    std::vector<double> node_lines() const;

  private:
    int degree_;
    std::size_t cells_;
    std::shared_ptr<const TensorMap<D>> map_;
    std::shared_ptr<const Points> control_;
    std::size_t control_columns_;
    std::shared_ptr<const PatchList> patches_;
    std::shared_ptr<const PatchParameters> parameters_;
    std::shared_ptr<const SolidShape> shape_;
    std::shared_ptr<const Mesh> mesh_;
    CollapsedSides<D> collapsed_;
};
using SplineDomain = TensorDomain<2>;
using SolidDomain = TensorDomain<3>;

} // namespace gaspard
