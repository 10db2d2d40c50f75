// Element integrals of the Monge-Ampere equation for quadratic elements on a surface, by quadrature of degree
// 8, eight cells at a time. McRae, Cotter, Budd, sections 3 and 4, with R = 1:
//
//   unit sphere     e = exp(grad phi) xi,    A = sigma P + e (x) k,    k = xi / |xi|,   P = I - k (x) k
//   flat surface    e = grad phi,            A = I + sigma
//
//   map loads       -<d_j v, e_i>            right-hand sides of <v, sigma_ij>, (4.9)
//                   <w, grad_i phi>          right-hand sides of the projected gradient, (4.10)
//   residual        <v, m det A>             (4.8)
//
// and their derivatives in the direction (dphi, dsigma, dm), with cof A = det A A^-T:
//
//   map loads       -<d_j v, de_i>,   <w, grad_i dphi>
//   residual        <v, dm det A + m cof A : dA>
//
// grad is the surface gradient on the computed facets. phi and sigma are quadratic on the reference cell for
// facets of order 1 and 2 alike. xi is a point of the facet, not projected to the sphere.
#pragma once

#include "core/fem/cell_quadrature.hpp"
#include "core/mesh/sphere_mesh.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

enum class SurfaceShape { unit_sphere, flat };

/// The cells of integration. Each cell has indices for its quadratic functions, for the nodes of its facet
/// and for the monitor's values, which are given at the nodes of the facet or at its corners only.
struct SurfaceCells {
    SurfaceShape shape = SurfaceShape::unit_sphere;
    CellKind quadratic, geometry;       ///< cell kind of phi; of the facets
    std::vector<std::int32_t> phi;      ///< rows in arrays of quadratic functions
    std::vector<std::int32_t> gradient; ///< rows in arrays of the projected gradient
    std::vector<std::int32_t> nodes;    ///< indices into `places`
    Points places;                      ///< xi
    bool monitor_at_corners = false;
};

class SurfaceElements {
  public:
    virtual ~SurfaceElements() = default;

    static constexpr std::size_t batch = 8; ///< cells per batch
    std::size_t batches() const { return (cells_ + batch - 1) / batch; }

    /// Adds the map loads of the batches begin .. end to rows of 12 numbers: nine loads of sigma by rows,
    /// then three of the gradient. For facets of order 1 the gradient's go to separate rows of 4 numbers.
    virtual void add_map_loads(std::size_t begin, std::size_t end, const double* phi, double* loads,
                               double* gradient_loads) const = 0;
    /// Adds the residual to r. `sigma` in rows of 12; `monitor` at the nodes of the facets.
    virtual void add_residual(std::size_t begin, std::size_t end, const double* phi, const double* sigma,
                              const double* monitor, double* r) const = 0;
    /// Add the derivatives of both in a given direction; same layouts.
    virtual void add_map_derivative(std::size_t begin, std::size_t end, const double* phi,
                                    const double* d_phi, double* loads, double* gradient_loads) const = 0;
    struct Fields {
        const double *phi, *sigma, *monitor;
    };
    virtual void add_residual_derivative(std::size_t begin, std::size_t end, const Fields& at,
                                         const Fields& direction, double* r) const = 0;
    /// A cell's matrices <v, w> and <grad v, grad w>, and <v, w> for functions of the order of the facets.
    virtual void mass(std::size_t cell, std::span<double> matrix) const = 0;
    virtual void stiffness(std::size_t cell, std::span<double> matrix) const = 0;
    virtual void facet_mass(std::size_t cell, std::span<double> matrix) const = 0;
    /// A cell's integrals <v, 1>.
    virtual void weights(std::size_t cell, std::span<double> weights) const = 0;

  protected:
    explicit SurfaceElements(std::size_t cells) : cells_(cells) {}
    std::size_t cells_;
};

std::unique_ptr<SurfaceElements> make_surface_elements(SurfaceCells cells);

} // namespace gaspard
