// The integrals of the Monge-Ampere equation over quadratic elements on a surface, eight cells at a time, by
// quadrature of degree 8. McRae, Cotter, Budd, sections 3 and 4, with R = 1:
//
//   on the unit sphere    e = exp(grad phi) xi,        A = sigma P + e (x) k,    k = xi / |xi|, P = I - k (x)
//   k on a flat surface     e = grad phi,                A = I + sigma
//
//   map loads     -<d_j v, e_i>     the right-hand sides of <v, sigma_ij>, (4.9)
//                 <w, grad_i phi>   those of the projected gradient, (4.10)
//   residual      <v, m det A>                                                       (4.8)
//
// and their derivatives, by dphi, dsigma and dm; cof A = det A A^-T:
//
//   map loads     -<d_j v, de_i>,  <w, grad_i dphi>
//   residual      <v, dm det A + m cof A : dA>
//
// grad is the surface gradient on the computed facets; phi and sigma are quadratic on the reference cell,
// whatever the order of the facets. xi is a point of the facet, not pushed out to the sphere.
#pragma once

#include "core/fem/cell_quadrature.hpp"
#include "core/mesh/sphere_mesh.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

enum class SurfaceShape { unit_sphere, flat };

/// What the integrals are taken over. Every cell has numbers for quadratic functions, for its facet's nodes
/// and for the monitor's values, which are those of the facet's nodes or of its corners.
struct SurfaceCells {
    SurfaceShape shape = SurfaceShape::unit_sphere;
    CellKind quadratic, geometry;       ///< of phi; of the facets
    std::vector<std::int32_t> phi;      ///< rows of the arrays that hold quadratic functions
    std::vector<std::int32_t> gradient; ///< rows of the projected gradient's
    std::vector<std::int32_t> nodes;    ///< of `places`
    Points places;                      ///< xi
    bool monitor_at_corners = false;
};

class SurfaceElements {
  public:
    virtual ~SurfaceElements() = default;

    static constexpr std::size_t batch = 8; ///< cells that are taken at once
    std::size_t batches() const { return (cells_ + batch - 1) / batch; }

    /// Of the batches begin .. end, added to rows of 12 numbers: nine loads of sigma, row by row, then three
    /// of the gradient; of facets of order 1 these go to rows of 4 numbers of their own.
    virtual void add_map_loads(std::size_t begin, std::size_t end, const double* phi, double* loads,
                               double* gradient_loads) const = 0;
    /// Added to r. `sigma` stands in rows of 12; `monitor` at the facets' nodes.
    virtual void add_residual(std::size_t begin, std::size_t end, const double* phi, const double* sigma,
                              const double* monitor, double* r) const = 0;
    /// The derivatives of both in a direction, which is given and added to in the same way.
    virtual void add_map_derivative(std::size_t begin, std::size_t end, const double* phi,
                                    const double* d_phi, double* loads, double* gradient_loads) const = 0;
    struct Fields {
        const double *phi, *sigma, *monitor;
    };
    virtual void add_residual_derivative(std::size_t begin, std::size_t end, const Fields& at,
                                         const Fields& direction, double* r) const = 0;
    /// A cell's matrices <v, w> and <grad v, grad w>, and <v, w> for functions of the facets' order.
    virtual void mass(std::size_t cell, std::span<double> matrix) const = 0;
    virtual void stiffness(std::size_t cell, std::span<double> matrix) const = 0;
    virtual void facet_mass(std::size_t cell, std::span<double> matrix) const = 0;
    /// Its <v, 1>.
    virtual void weights(std::size_t cell, std::span<double> weights) const = 0;

  protected:
    explicit SurfaceElements(std::size_t cells) : cells_(cells) {}
    std::size_t cells_;
};

std::unique_ptr<SurfaceElements> make_surface_elements(SurfaceCells cells);

} // namespace gaspard
