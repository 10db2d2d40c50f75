// Two convex domains, the source and the target, and a mesh of the source: triangles in rings
// (transport/ring_mesh.hpp), or those of a file, with Lagrange elements of degree 1, 2 or 3. Those in rings
// are straight or isoparametric; those of a file are straight, and the source is their polygon.
//
// The mesh of the run has cells of order 1 (degree 1) or 2; those of degree 3 are shown by the values at the
// corners and the middles of edges.
#pragma once

#include "core/mesh/data_context.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/transport/convex_curve.hpp"
#include "core/transport/lagrange_triangles.hpp"
#include "core/transport/source_mesh.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

namespace gaspard {

/// The range of domain.cells.
inline constexpr int fewest_domain_rings = 2, most_domain_rings = 128;
/// The largest domain.refinements.
inline constexpr int most_domain_refinements = 4;

class TransportDomain final : public Discretisation {
  public:
    struct Setup {
        std::shared_ptr<const ConvexCurve> source, target; ///< no source if there is a mesh
        std::shared_ptr<const SourceMesh> mesh{};          ///< null: rings
        int refinements = 0;                               ///< of the mesh
        int rings = 16;
        int degree = 1;
        bool curved = true;
        /// Added to the source's nodes, which have small coordinates: curves and mesh are relative to it, the
        /// target's to target_origin.
        Vec3 source_origin{}, target_origin{};
        std::string source_name; ///< identifies the source: two domains with equal names have equal sources
    };
    /// Throws InputError if a mesh has no inner nodes; Interrupted if asked to stop.
    explicit TransportDomain(Setup setup, const std::stop_token& stop = {});

    std::shared_ptr<const Mesh> mesh() const override { return mesh_; }
    std::shared_ptr<const Points> target_outline() const override { return outline_; }
    /// Where densities are known, in the user's coordinates.
    std::shared_ptr<const DensityDomain> source_region() const override;
    std::shared_ptr<const DensityDomain> target_region() const override;
    /// Whether a domain is too thin for elements of degree 1.
    std::vector<std::string> notes() const override;
    std::size_t unknowns() const override { return elements_.nodes().size() + 1; }

    const Setup& setup() const { return setup_; }
    const LagrangeTriangles& elements() const { return elements_; } ///< relative to source_origin
    /// The nodes of the mesh of the run, from values at the nodes of the elements, `count` numbers each.
    std::vector<double> at_mesh_nodes(std::span<const double> values, std::size_t count) const;

  private:
    LagrangeTriangles make_elements(const std::stop_token& stop);
    void make_mesh();

    Setup setup_;
    LagrangeTriangles elements_;
    std::shared_ptr<const Mesh> mesh_;
    std::shared_ptr<const Points> outline_; ///< of the target
    std::vector<std::size_t> shown_; ///< degree 3: for the mesh's nodes 2 x (cell, place), see at_mesh_nodes
};

DomainType transport_domain();
/// `folder` is the base of a relative path. The file is read if `content` (DomainType::read) is null. Throws
/// InputError, and Interrupted if asked to stop.
std::shared_ptr<const TransportDomain> make_transport_domain(const Values& values,
                                                             const std::filesystem::path& folder = {},
                                                             const DomainContent& content = {},
                                                             const std::stop_token& stop = {});

} // namespace gaspard
