// The prescribed Jacobian for a monitor rho on a patch F, for either measure of the cells, with J = the area
// element of F (|det grad F|, on a surface sqrt(det(grad F^T grad F))):
//
//   parameter   f = sigma / rho(F(Psi))                      Bahari et al. (3.15)
//               sigma = integral of rho(F(xi))
//
//   physical    f = sigma J(xi) / (rho(F(Psi)) J(Psi))
//               sigma = (integral of rho(F(xi)) J(xi)) / (integral of J(xi))
//
// over the parameter square. The first gives equal areas of the square equal integrals of rho over it, the
// second gives cells in space integrals of rho in proportion to the areas of their uniform ancestors. Where J
// is constant they are the same. sigma is computed with the quadrature of the iteration.
#pragma once

#include "core/method/bfo.hpp"
#include "core/monitor/monitor.hpp"
#include "core/spline/patch_map.hpp"

namespace gaspard {

/// In which measure cells of a patch are to have the share of rho that their uniform ancestors have of it.
enum class Measure { parameter, physical };

class PatchSource final : public JacobianSource {
  public:
    /// `monitor`, `map` and `areas` must outlive this object. `areas`: J at the quadrature points for
    /// Measure::physical (area_elements()), empty for Measure::parameter.
    PatchSource(const Monitor& monitor, const PatchMap& map, const SplineLine& line,
                std::span<const double> areas = {});

    double sigma() const { return sigma_; }
    /// rho(F(psi)) at the points of the last call of values(); `f`: its result.
    void monitor_values(std::span<const double> f, std::span<double> rho) const;
    void values(std::size_t y, const Points& psi, std::span<double> f) const override;
    void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const override;

  private:
    /// F(psi).
    const Points& place(const Points& psi) const;
    /// J at the quadrature points of `count` points from row y on.
    std::span<const double> areas_of(std::size_t y, std::size_t count) const {
        return areas_.subspan(y * row_, count);
    }

    const Monitor& monitor_;
    const PatchMap& map_;
    std::span<const double> areas_;
    std::size_t row_; ///< points in a row
    double sigma_ = 0;
    mutable Points x_, slope_, first_, second_; ///< workspace for a band of points
    mutable std::vector<double> area_;
};

/// J at the quadrature points of a form, row by row.
std::vector<double> area_elements(const PatchMap& map, const SplineLine& line);

} // namespace gaspard
