// The mixed finite elements of McRae, Cotter, Budd, section 4.2, on a closed surface of triangles or
// quadrilaterals: the unit sphere, or a flat periodic plane.
//
//   V, Sigma = quadratic elements on the computed facets, which have order 1 or 2
//
//   w = projection of grad phi to the facets' space                                       (4.10)
//   w' = w - (w . xi) xi,   x = exp(w') xi            at its nodes                        (4.11), (4.12)
//   <tau, sigma> = -<div tau, exp(grad phi) xi>       for all tau in Sigma                (4.9)
//   theta = integral of m det(sigma P + exp(grad phi) xi (x) xi) / area
//   r_v = <v, m det(...) - theta>                     for all v in V                      (4.8), (5.1)
//   <grad v, grad u> = r_v                            for all v in V, mean of u = 0       (3.7)
//
// m is a function of the facets' space, or linear between the vertices. All computations are on the unit
// sphere; another radius only scales positions that are returned and points at which monitors are evaluated.
//
// A function of V is an array with one value per unknown. On the sphere, unknowns are numbered like the nodes
// of the quadratic mesh, vertices first. The moving mesh has the nodes of the facets.
#pragma once

#include "core/fem/surface_elements.hpp"
#include "core/linear/cell_cholesky.hpp"
#include "core/mesh/discretisation.hpp"

#include <optional>
#include <stop_token>

namespace gaspard {

/// The surface and its discretisation.
struct SurfaceSetup {
    SurfaceMesh mesh;                     ///< radius 1
    std::vector<std::int32_t> unknowns{}; ///< unknown of each node, vertices first; empty: identity
    SurfaceShape shape = SurfaceShape::unit_sphere;
    int geometry_order = 2;
    bool monitor_at_vertices = false;
    double radius = 1;
    std::optional<SphereGrid> grid{}; ///< set if the mesh is sphere_mesh(grid)
};

/// For one of the sphere meshes.
SurfaceSetup sphere_setup(const SphereGrid& grid, int geometry_order = 2, double radius = 1,
                          bool monitor_at_vertices = false);

class SurfaceQ2 final : public Discretisation {
  public:
    /// Assembles and factorises the matrices. Throws Interrupted when a stop is requested.
    explicit SurfaceQ2(SurfaceSetup setup, const Progress& progress = {}, std::stop_token stop = {});

    std::shared_ptr<const Mesh> mesh() const override { return mesh_; }
    std::size_t unknowns() const override { return phi_cells_.count; }
    SurfaceShape shape() const { return shape_; }
    double radius() const { return radius_; }
    int geometry_order() const { return curved_ ? 2 : 1; }
    bool monitor_at_vertices() const { return monitor_at_vertices_; }
    const std::optional<SphereGrid>& grid() const { return grid_; }
    /// xi at the nodes of mesh(); radius 1.
    const Points& places() const { return places_; }
    /// The mesh of V and Sigma: order 2, radius 1.
    const Mesh& quadratic() const { return quadratic_; }
    /// Area of the computed facets.
    double area() const { return area_; }
    /// Number of entries in the factors of the mass and stiffness matrices.
    std::size_t factor_entries() const { return mass_->entries() + stiffness_->entries(); }

    /// Buffers of one caller, so that operators do not allocate.
    struct Workspace {
        std::vector<double> phi, r;   ///< in elimination order
        std::vector<double> rows;     ///< 12 per unknown: sigma by rows, then w; first loads, then solutions
        std::vector<double> gradient; ///< 4 per unknown of facets of order 1: w
    };
    Workspace make_workspace() const;

    /// (4.9) and (4.10): computes sigma and w into the workspace.
    void map(std::span<const double> phi, Workspace& workspace) const;
    /// After map: x at the nodes of mesh(), on the sphere of its radius, and w' there for radius 1.
    void positions(const Workspace& workspace, Points& x, Points& gradient) const;
    /// <v, 1> for every unknown.
    std::span<const double> weights() const { return weights_; }
    /// After map: sigma at a node of mesh(), 3 x 3 by rows.
    std::span<const double> sigma(const Workspace& workspace, std::size_t node) const;

    struct Residual {
        double theta = 0;
        double normalised = 0; ///< l2 norm of r / l2 norm of <v, theta>
    };
    /// After map: r for the monitor's values at the nodes of mesh().
    Residual residual(std::span<const double> monitor, std::span<double> r, Workspace& workspace) const;
    /// The derivative of map in direction w. `workspace` as left by map; `d_workspace` receives the
    /// derivative.
    void map_derivative(const Workspace& workspace, std::span<const double> w, Workspace& d_workspace) const;
    /// The derivative of x; `gradient` as returned by positions.
    void positions_derivative(const Points& gradient, const Workspace& d_workspace, Points& dx) const;
    /// The derivative of r, with dm at the nodes of mesh().
    void residual_derivative(std::span<const double> monitor, const Workspace& workspace,
                             std::span<const double> d_monitor, Workspace& d_workspace,
                             std::span<double> dr) const;
    /// Values at the unknowns from values at the nodes of mesh(); elsewhere the mean over the cell.
    std::vector<double> at_unknowns(std::span<const double> nodal) const;
    /// u with <grad v, grad u> = r_v and mean 0, for r of sum 0. u may be r.
    void poisson(std::span<const double> r, std::span<double> u, Workspace& workspace) const;

    /// The weak Laplacian l of phi: <v, l> = -<grad v, grad phi>.
    std::vector<double> laplacian(std::span<const double> phi) const;
    /// The inverse of laplacian: phi of mean 0 from the values of l; the mean of l is dropped.
    std::vector<double> potential(std::span<const double> l) const;

  private:
    /// Applies a matrix, given cell by cell, to a function.
    using CellMatrix = void (SurfaceElements::*)(std::size_t, std::span<double>) const;
    std::vector<double> apply(CellMatrix matrix, std::span<const double> f) const;
    void number_unknowns(const SurfaceSetup& setup);
    void factorise(const Progress& progress, std::stop_token stop);
    Points middles() const;

    SurfaceShape shape_;
    double radius_;
    bool monitor_at_vertices_;
    std::optional<SphereGrid> grid_;
    Mesh quadratic_;
    Points places_;
    std::shared_ptr<const Mesh> mesh_;
    bool curved_; ///< facets of order 2: the facets' space is V
    CellUnknowns phi_cells_, facet_cells_;
    std::vector<std::int32_t> node_unknown_; ///< for each node of mesh(): its unknown in the facets' space
    std::shared_ptr<const Dissection> dissection_, facet_dissection_;
    std::unique_ptr<const SurfaceElements> elements_; ///< cells in the order of the dissection
    std::unique_ptr<const CellCholesky> mass_, stiffness_, facet_mass_;
    Vec3 projected_gradient(const Workspace& workspace, std::size_t node) const;
    double take_mean(const Workspace& workspace, std::span<double> r) const;

    std::vector<double> weights_; ///< <v, 1>
    double area_ = 0;
};

} // namespace gaspard
