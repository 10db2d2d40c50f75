// The standard form on a patch or a solid as a nonlinear problem for phi = Phi - |xi|^2 / 2, with Psi = grad
// Phi:
//
//   r_v = <Psi . n, v>_boundary - <s G(Phi), v> - <grad Phi, grad v>
//
// Its solution is the fixed point of the method picard; direction() is the Picard increment, so that
// relaxation with step size 1 is Picard's method. The normalised residual is |r| / |<v, d>|, where d = 2 or 3
// is the divergence of the identity map.
#pragma once

#include "core/method/monge_ampere.hpp"
#include "core/method/patch_form.hpp"

namespace gaspard {

template <std::size_t D>
class TensorEquation final : public MongeAmpereEquation {
  public:
    explicit TensorEquation(std::shared_ptr<const TensorDomain<D>> domain)
        : TensorEquation(domain, domain->cells()) {}
    /// On a coarser mesh than that of the domain.
    TensorEquation(std::shared_ptr<const TensorDomain<D>> domain, std::size_t cells);

    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    State adopt(NonlinearProblem& other, std::span<const double> phi) override;
    std::unique_ptr<NonlinearProblem> coarser(const Progress& progress, std::stop_token stop) const override;

    /// method.measure.
    void configure(const Values& method) override { patch_->set_measure(measure_of(method)); }
    Evaluation evaluate(const ProblemData& data, std::span<const double> phi) override;
    const Points& positions() const override { return positions_; }
    std::vector<SeriesInfo> series() const override;
    std::vector<double> measures(const ProblemData& data) override {
        return values_of(patch_->measure(*data.monitor, shown_), D);
    }
    bool knows_map() const override { return true; }
    std::vector<std::uint32_t> folded_cells() override { return patch_->folded_cells(shown_); }
    void move(std::span<const double> phi) override;
    std::span<const double> residual() const override { return residual_; }
    Ellipticity ellipticity() const override { return {shape_.convexity, shape_.slowest, shape_.fastest}; }
    void direction(std::span<double> u) override;
    double step_unit(const ProblemData&) const override { return 1; } // of Picard's increment

    void linearise(const ProblemData& data, Linearised how) override;
    void derivative(std::span<const double> w, std::span<double> out) override { bfo_.derivative(w, out); }
    void precondition(std::span<const double> r, std::span<double> u) override { bfo_.poisson(r, u); }

    void use_threads(int threads) override;
    double other_cpu_seconds() const override { return bfo_.other_cpu_seconds(); }

  private:
    TensorEquation(std::shared_ptr<const TensorDomain<D>> domain, std::unique_ptr<MappedForm<D>> patch);

    std::shared_ptr<const TensorDomain<D>> domain_;
    std::unique_ptr<MappedForm<D>> patch_;
    std::size_t threads_ = 1;
    BfoIteration<D> bfo_;
    double unit_ = 0; ///< |<v, d>|
    Points positions_;
    typename BfoIteration<D>::Shape shape_;
    std::vector<double> whole_, next_, residual_; ///< Phi, T(Phi), r
    std::vector<double> shown_;                   ///< the Phi of positions()
};
using SplineEquation = TensorEquation<2>;
using SolidEquation = TensorEquation<3>;

} // namespace gaspard
