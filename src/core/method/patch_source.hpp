// The prescribed Jacobian for a monitor rho on a patch F, in the parameter square; Bahari et al. (3.15):
//
//   f = sigma / rho(F(Psi)),   sigma = integral of rho(F(xi)) over the parameter square
//
// sigma is computed with the quadrature of the iteration.
#pragma once

#include "core/method/bfo.hpp"
#include "core/monitor/monitor.hpp"
#include "core/spline/patch_map.hpp"

namespace gaspard {

class PatchSource final : public JacobianSource {
  public:
    /// `monitor` and `map` must outlive this object.
    PatchSource(const Monitor& monitor, const PatchMap& map, const SplineLine& line);

    double sigma() const { return sigma_; }
    void values(std::size_t y, const Points& psi, std::span<double> f) const override;
    void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const override;

  private:
    /// F(psi).
    const Points& place(const Points& psi) const;

    const Monitor& monitor_;
    const PatchMap& map_;
    double sigma_ = 0;
    mutable Points x_, slope_, first_, second_; ///< workspace for a band of points
};

} // namespace gaspard
