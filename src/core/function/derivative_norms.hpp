// Norms of the derivatives of a function u on a domain:
//
//   |grad u|   of the Cartesian gradient; on spheres and surfaces of the tangential one, P grad u,
//              P = I - n n^T
//   |H|_F      of the Hessian H = D grad u; on spheres and surfaces of the covariant one, H = P D(P grad u) P
//
// Gradients are those of u, hence exact where u has exact ones. H is their central difference along
// orthogonal tangents, over 2e-5 of the domain's size: a relative error of 1e-4 where u varies over 1e-3 of
// the size.
#pragma once

#include "core/function/scalar_function.hpp"
#include "core/mesh/chart.hpp"

#include <memory>
#include <span>

namespace gaspard {

/// Immutable; refers to u.
class DerivativeNorms {
  public:
    /// `size`: of the domain, a length. `box`: differences take points of the chart's box alone, as u may not
    /// go on beside it.
    DerivativeNorms(const ScalarFunction& u, std::shared_ptr<const Chart> chart, double size, bool box);

    /// At points x of the domain with coordinates s; x.size() norms. Not finite where u's gradients are not.
    void gradients(const Points& s, const Points& x, std::span<double> norms) const;
    void hessians(const Points& s, const Points& x, std::span<double> norms) const;

  private:
    void tangential(const Points& s, const Points& x, Points& gradients) const;
    void keep_finite(const Points& s, const Points& x, Points& moved, Points& gradients) const;
    void frame(const Points& s, const Points& x, Points& first, Points& second) const;
    void shift(const Points& s, const Points& x, const Points& direction, double length, Points& moved_s,
               Points& moved_x) const;

    const ScalarFunction& u_;
    std::shared_ptr<const Chart> chart_;
    double step_;
    bool box_;
};

} // namespace gaspard
