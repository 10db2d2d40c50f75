// f = sigma / rho(F(Psi)), (3.15): a monitor rho on a patch F, seen from the parameter square. Sigma is the
// mean of rho o F there, by the quadrature of the iteration.
#pragma once

#include "core/method/bfo.hpp"
#include "core/monitor/monitor.hpp"
#include "core/spline/patch_map.hpp"

namespace gaspard {

class PatchSource final : public JacobianSource {
  public:
    /// All three outlive it.
    PatchSource(const Monitor& monitor, const PatchMap& map, const SplineLine& line);

    double sigma() const { return sigma_; }
    void values(std::size_t y, const Points& psi, std::span<double> f) const override;
    void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const override;

  private:
    /// Where the points of psi are.
    const Points& place(const Points& psi) const;

    const Monitor& monitor_;
    const PatchMap& map_;
    double sigma_ = 0;
    mutable Points x_, slope_, first_, second_; ///< room for a band of points
};

} // namespace gaspard
