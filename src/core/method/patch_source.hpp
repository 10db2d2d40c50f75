// The prescribed Jacobian for a monitor rho on a patch F, for either measure of the cells, with J = the
// element of area or volume of F (|det grad F|, on a surface sqrt(det(grad F^T grad F))):
//
//   parameter   f = sigma / rho(F(Psi))                      Bahari et al. (3.15)
//               sigma = integral of rho(F(xi))
//
//   physical    f = sigma J(xi) / (rho(F(Psi)) J(Psi))
//               sigma = (integral of rho(F(xi)) J(xi)) / (integral of J(xi))
//
// over the parameter square or cube. The first gives equal parts of it equal integrals of rho over them, the
// second gives cells in space integrals of rho in proportion to the sizes of their uniform ancestors. Where J
// is constant they are the same. sigma is computed with the quadrature of the iteration.
#pragma once

#include "core/method/bfo.hpp"
#include "core/monitor/monitor.hpp"
#include "core/spline/patch_map.hpp"

#include <memory>
#include <mutex>

namespace gaspard {

/// In which measure cells of a patch are to have the share of rho that their uniform ancestors have of it.
enum class Measure { parameter, physical };

template <std::size_t D>
class TensorSource final : public JacobianSource {
  public:
    /// `monitor`, `map` and `elements` must outlive this object. `elements`: J at the quadrature points for
    /// Measure::physical (elements_of()), empty for Measure::parameter.
    TensorSource(const Monitor& monitor, const TensorMap<D>& map, const SplineLine& line,
                 std::span<const double> elements = {});

    double sigma() const { return sigma_; }
    void values(std::size_t y, const Points& psi, std::span<double> f) const override;
    void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const override;
    /// values(), and rho(F(psi)).
    void values(std::size_t y, const Points& psi, std::span<double> f, std::span<double> rho) const;

  private:
    /// For a band of points.
    struct Workspace {
        Points x, slope;
        std::array<Points, D> tangents;
        std::vector<double> element;
    };
    /// Several threads may ask at once: each call takes a workspace, or makes one, and gives it back.
    class Borrowed;

    /// rho(F(psi)); with elements also J(psi).
    void densities(const Points& psi, std::span<double> rho, Workspace& workspace) const;
    /// f from rho.
    void sources(std::size_t y, std::span<double> f, const Workspace& workspace) const;
    /// J at the quadrature points of `count` points from slab y on.
    std::span<const double> elements_at(std::size_t y, std::size_t count) const {
        return elements_.subspan(y * slab_, count);
    }

    const Monitor& monitor_;
    const TensorMap<D>& map_;
    std::span<const double> elements_;
    std::size_t slab_; ///< points in a slab
    double sigma_ = 0;
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<Workspace>> free_;
    mutable std::size_t made_ = 0; ///< workspaces
};
using PatchSource = TensorSource<2>;
using SolidSource = TensorSource<3>;

/// Calls work(slab, xi, weights) for the quadrature points of every slab of [0, 1]^D.
template <std::size_t D, class Work>
void for_each_slab(const SplineLine& line, const Work& work) {
    const std::size_t n = line.points.size(), slab = tensor_size<D - 1>(n);
    Points xi(slab);
    std::vector<double> weights(slab);
    for (std::size_t s = 0; s < n; ++s) {
        for (std::size_t i = 0; i < slab; ++i) {
            if constexpr (D == 2) {
                xi.set(i, {line.points[i], line.points[s], 0});
                weights[i] = line.weights[i];
            } else {
                xi.set(i, {line.points[i % n], line.points[i / n], line.points[s]});
                weights[i] = line.weights[i % n] * line.weights[i / n];
            }
        }
        work(s, xi, std::span<const double>(weights));
    }
}

/// J at the quadrature points of a form, slab by slab.
template <std::size_t D>
std::vector<double> elements_of(const TensorMap<D>& map, const SplineLine& line);

} // namespace gaspard
