#include "core/method/spline_equation.hpp"

#include "core/linear/reduce.hpp"

#include <cmath>

namespace gaspard {

namespace {

/// Cells per direction of the coarsest mesh.
constexpr std::size_t coarsest_spline(std::size_t dimension) { return dimension == 2 ? 16 : 8; }

} // namespace

template <std::size_t D>
TensorEquation<D>::TensorEquation(std::shared_ptr<const TensorDomain<D>> domain, std::size_t cells)
    : TensorEquation(domain, std::make_unique<MappedForm<D>>(domain, Formulation::standard, cells)) {}

template <std::size_t D>
TensorEquation<D>::TensorEquation(std::shared_ptr<const TensorDomain<D>> domain,
                                  std::unique_ptr<MappedForm<D>> patch)
    : MongeAmpereEquation(patch->layout(), patch->form()->unknowns()), domain_(std::move(domain)),
      patch_(std::move(patch)), bfo_(patch_->form()), unit_(norm_of_divergence(*patch_->form())),
      whole_(size()), next_(size()), residual_(size()) {}

template <std::size_t D>
std::optional<State> TensorEquation<D>::adopt(const State& other, const Discretisation*) {
    if (other.arrays.size() != 1 || other.arrays[0].name != "phi") return std::nullopt;
    auto phi = patch_->adopt(other.layout, other.arrays[0].values);
    if (phi.empty()) return std::nullopt;
    return state_of(std::move(phi));
}

template <std::size_t D>
State TensorEquation<D>::adopt(NonlinearProblem& other, std::span<const double> phi) {
    return state_of(patch_->adopt(other.layout(), phi));
}

template <std::size_t D>
std::unique_ptr<NonlinearProblem> TensorEquation<D>::coarser(const Progress&, std::stop_token) const {
    const std::size_t cells = patch_->cells();
    if (cells % 2 != 0 || cells / 2 < coarsest_spline(D)) return nullptr;
    return std::make_unique<TensorEquation>(domain_, cells / 2);
}

template <std::size_t D>
Evaluation TensorEquation<D>::evaluate(const ProblemData& data, std::span<const double> phi) {
    const TensorSource<D> source = patch_->source(*data.monitor);
    patch_->add_identity(phi, whole_);
    bfo_.iterate(source, whole_, next_, &shape_);
    bfo_.residual(whole_, next_, residual_);
    shown_ = whole_;
    patch_->positions(shown_, positions_);
    return {.residual = std::sqrt(dot(residual_, residual_)) / unit_, .series = {data.unit * source.sigma()}};
}

template <std::size_t D>
std::vector<SeriesInfo> TensorEquation<D>::series() const {
    std::vector<SeriesInfo> all = patch_series(D);
    all.insert(all.begin(), theta_series());
    return all;
}

template <std::size_t D>
void TensorEquation<D>::move(std::span<const double> phi) {
    shown_.resize(phi.size());
    patch_->add_identity(phi, shown_);
    patch_->positions(shown_, positions_);
}

template <std::size_t D>
void TensorEquation<D>::direction(std::span<double> u) {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = next_[i] - whole_[i];
}

template <std::size_t D>
void TensorEquation<D>::linearise(const ProblemData& data, Linearised how) {
    bfo_.linearise(patch_->source(*data.monitor), whole_, how == Linearised::fully);
}

template <std::size_t D>
void TensorEquation<D>::use_threads(int threads) {
    const auto wanted = static_cast<std::size_t>(threads);
    if (D == 2 || wanted == threads_) return; // sums of the square are too short to be shared
    threads_ = wanted;
    bfo_ = BfoIteration<D>(patch_->form(), 0, threads_);
}

template class TensorEquation<2>;
template class TensorEquation<3>;

} // namespace gaspard
