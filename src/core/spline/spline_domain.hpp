// A patch divided into n x n cells with the spline spaces for its mesh, and the table of patches that a user
// can choose.
#pragma once

#include "core/mesh/discretisation.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/spline/patch_map.hpp"
#include "core/spline/spline_forms.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace gaspard {

/// Edges of a patch that are one point, such as the tip of a cone.
struct PointEdges {
    bool left = false, right = false, bottom = false, top = false; ///< xi1 = 0, xi1 = 1, xi2 = 0, xi2 = 1
};

class SplineDomain final : public Discretisation {
  public:
    SplineDomain(int degree, std::size_t cells, std::shared_ptr<const PatchMap> map,
                 std::shared_ptr<const Points> control = nullptr,
                 std::shared_ptr<const PatchList> patches = nullptr);

    /// Quadrilaterals whose order is the degree p, so that they carry Psi exactly and F(Psi) to order p + 1;
    /// (p n + 1)^2 nodes on the patch, xi1 fastest.
    std::shared_ptr<const Mesh> mesh() const override { return mesh_; }
    std::shared_ptr<const Points> control_points() const override { return control_; }
    std::shared_ptr<const PatchList> patches() const override { return patches_; }
    std::shared_ptr<const PatchParameters> parameters() const override { return parameters_; }
    std::shared_ptr<const PatchMap> patch_map() const override { return map_; }
    /// Unknowns of the standard form.
    std::size_t unknowns() const override;

    int degree() const { return degree_; }
    std::size_t cells() const { return cells_; }
    const PointEdges& point_edges() const { return point_edges_; }
    /// Parameters of the nodes along each direction of the parameter square.
    std::vector<double> node_lines() const;

  private:
    int degree_;
    std::size_t cells_;
    std::shared_ptr<const PatchMap> map_;
    std::shared_ptr<const Points> control_;
    std::shared_ptr<const PatchList> patches_;
    std::shared_ptr<const PatchParameters> parameters_;
    std::shared_ptr<const Mesh> mesh_;
    PointEdges point_edges_;
};

/// The domain whose patch comes from a file (domain.file).
inline constexpr std::string_view own_patch_domain = "spline-patch";

/// Square, disk, quarter annulus, part of a torus, Möbius strip, and a patch from a file.
std::vector<DomainType> spline_domains();
/// `folder` is the base of a relative path. The file is read if `content` (DomainType::read) is null. Throws
/// InputError if the patch is invalid.
std::shared_ptr<const SplineDomain> make_spline_domain(const std::string& type, const Values& values,
                                                       const std::filesystem::path& folder = {},
                                                       const DomainContent& content = {});

} // namespace gaspard
