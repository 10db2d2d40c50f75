#include "core/method/spline_equation.hpp"

#include "core/linear/reduce.hpp"

#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t coarsest_spline = 16;

} // namespace

SplineEquation::SplineEquation(std::shared_ptr<const SplineDomain> domain, std::size_t cells)
    : SplineEquation(domain, std::make_unique<PatchForm>(domain, Formulation::standard, cells)) {}

SplineEquation::SplineEquation(std::shared_ptr<const SplineDomain> domain, std::unique_ptr<PatchForm> patch)
    : MongeAmpereEquation(patch->layout(), patch->form()->unknowns()), domain_(std::move(domain)),
      patch_(std::move(patch)), bfo_(patch_->form()), unit_(norm_of_divergence(*patch_->form())),
      whole_(size()), next_(size()), residual_(size()) {}

std::optional<State> SplineEquation::adopt(const State& other, const Discretisation*) {
    if (other.arrays.size() != 1 || other.arrays[0].name != "phi") return std::nullopt;
    auto phi = patch_->adopt(other.layout, other.arrays[0].values);
    if (phi.empty()) return std::nullopt;
    return state_of(std::move(phi));
}

State SplineEquation::adopt(NonlinearProblem& other, std::span<const double> phi) {
    return state_of(patch_->adopt(other.layout(), phi));
}

std::unique_ptr<NonlinearProblem> SplineEquation::coarser(const Progress&, std::stop_token) const {
    const std::size_t cells = patch_->cells();
    if (cells % 2 != 0 || cells / 2 < coarsest_spline) return nullptr;
    return std::make_unique<SplineEquation>(domain_, cells / 2);
}

Evaluation SplineEquation::evaluate(const ProblemData& data, std::span<const double> phi) {
    const PatchSource source = patch_->source(*data.monitor);
    patch_->add_identity(phi, whole_);
    bfo_.iterate(source, whole_, next_, &shape_);
    bfo_.residual(whole_, next_, residual_);
    shown_ = whole_;
    patch_->positions(shown_, positions_);
    return {.residual = std::sqrt(dot(residual_, residual_)) / unit_, .series = {data.unit * source.sigma()}};
}

std::vector<SeriesInfo> SplineEquation::series() const {
    std::vector<SeriesInfo> all = patch_series();
    all.insert(all.begin(), theta_series());
    return all;
}

void SplineEquation::move(std::span<const double> phi) {
    shown_.resize(phi.size());
    patch_->add_identity(phi, shown_);
    patch_->positions(shown_, positions_);
}

void SplineEquation::direction(std::span<double> u) {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = next_[i] - whole_[i];
}

void SplineEquation::linearise(const ProblemData& data, Linearised how) {
    bfo_.linearise(patch_->source(*data.monitor), whole_, how == Linearised::fully);
}

} // namespace gaspard
