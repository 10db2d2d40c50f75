#include "core/method/interval_method.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

namespace gaspard {

namespace {

constexpr std::string_view layout_prefix = "interval n=";
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<double> component(const IntervalSolution& solution, std::size_t k) {
    return k < solution.nodes.size() ? solution.nodes[k] : std::vector<double>{};
}

} // namespace

std::vector<double> resampled_interval(std::span<const double> x, std::size_t n) {
    const std::size_t from = x.size() - 1;
    if (n == 2 * from) return refined_interval(x);
    std::vector<double> y(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
        const std::size_t cell = std::min(i * from / n, from - 1);
        const double s = static_cast<double>(i * from - cell * n) / static_cast<double>(n);
        y[i] = s == 0 ? x[cell] : s == 1 ? x[cell + 1] : x[cell] + s * (x[cell + 1] - x[cell]);
    }
    return y;
}

IntervalMethod::IntervalMethod(std::shared_ptr<const IntervalDomain> domain) : domain_(std::move(domain)) {}

State IntervalMethod::initial_state() const {
    return {std::string(layout_prefix) + std::to_string(domain_->cells()),
            {{"x", uniform_interval(domain_->interval(), domain_->cells())}}};
}

const std::vector<double>& IntervalMethod::mesh_of(const State& state) {
    GASPARD_CHECK(state.arrays.size() == 1 && state.arrays[0].values.size() >= 2);
    return state.arrays[0].values;
}
std::vector<double>& IntervalMethod::mesh_of(State& state) {
    return const_cast<std::vector<double>&>(mesh_of(std::as_const(state)));
}

std::optional<State> IntervalMethod::adopt(const State& other, const Discretisation*) {
    if (!other.layout.starts_with(layout_prefix) || other.arrays.size() != 1 ||
        other.arrays[0].values.size() < 2)
        return std::nullopt;
    State state = initial_state();
    if (other.layout == state.layout && other.arrays[0].values.front() == domain_->interval().a &&
        other.arrays[0].values.back() == domain_->interval().b)
        return other; // also of a coarser mesh
    std::vector<double> x = other.arrays[0].values;
    const double from = x.front(), length = x.back() - from, a = domain_->interval().a;
    const double scale = (domain_->interval().b - a) / length;
    if (!(length > 0)) return std::nullopt;
    if (scale != 1 || from != a)
        for (double& one : x) one = a + scale * (one - from);
    x.front() = a, x.back() = domain_->interval().b;
    mesh_of(state) = resampled_interval(x, static_cast<std::size_t>(domain_->cells()));
    return state;
}

void IntervalMethod::look_at(const ProblemData& data, std::vector<double> x) {
    take_problem(data);
    x_ = std::move(x);
    solved_.reset();
    positions_.resize(0);
}

const Points& IntervalMethod::positions() {
    if (positions_.size() == 0) {
        const auto n = static_cast<std::size_t>(domain_->cells());
        positions_ = Points(n + 1);
        positions_.x = x_.size() == n + 1 ? x_ : resampled_interval(x_, n);
    }
    return positions_;
}

/// Keeps the problem, and its solution on the uniform mesh, while its values do.
void IntervalMethod::take_problem(const ProblemData& data) {
    if (data.pde == pde_values_ && data.pde_type == pde_type_) return;
    std::optional<IntervalPde> made;
    if (data.pde) made = interval_pde(data.pde_type, *data.pde, domain_->interval());
    if (made) coefficients_at(made->problem, domain_->mesh()->nodes.x); // Gauss points miss the ends
    pde_values_ = data.pde;
    pde_type_ = data.pde_type;
    pde_ = std::move(made);
    solved_.reset();
    uniform_.reset();
}

IntervalMethod::Solved IntervalMethod::solved_on(std::span<const double> x) const {
    const IntervalProblem& problem = pde_->problem;
    const IntervalCoefficients at = coefficients_on(problem, x);
    Solved made{solve_interval(problem, at, x, 1)};
    made.reference_error = reference_error(problem, x, made.solution, solve_interval(problem, at, x, 2));
    made.exact_error = pde_->exact ? exact_error(problem, x, made.solution, *pde_->exact) : unknown;
    return made;
}

const IntervalMethod::Solved& IntervalMethod::solved() {
    if (!solved_) solved_ = solved_on(positions().x);
    return *solved_;
}

const IntervalMethod::Solved& IntervalMethod::solved_on_uniform() {
    if (!uniform_) uniform_ = solved_on(domain_->mesh()->nodes.x);
    return *uniform_;
}

std::vector<SeriesInfo> IntervalMethod::series() const { return energy_error_series(); }

std::vector<SeriesInfo> energy_error_series() {
    const auto error = [](const char* name, const char* part, const char* help) {
        return SeriesInfo{.name = name,
                          .label = std::string("Energy error, ") + part,
                          .symbol = "‖u − uₕ‖_E",
                          .scale = ParameterScale::logarithmic,
                          .help = help,
                          .plot = SharedPlot{"energy_error", "Energy error", part},
                          .measured = true};
    };
    return {
        error("energy_error", "P2 reference", "of the solution in P1, against that in P2 on the same mesh"),
        error("exact_energy_error", "exact", "of the solution in P1, against the exact one"),
        error("uniform_energy_error", "P2 reference, uniform", "the same on the uniform mesh"),
        error("uniform_exact_energy_error", "exact, uniform", "the same on the uniform mesh")};
}

std::vector<double> IntervalMethod::measures(const ProblemData& data) {
    take_problem(data);
    if (!pde_) return {unknown, unknown, unknown, unknown};
    const Solved &here = solved(), &uniform = solved_on_uniform();
    return {here.reference_error, here.exact_error, uniform.reference_error, uniform.exact_error};
}

std::vector<FieldInfo> layer_fields() {
    const auto node = [](const char* name, const char* label, const char* symbol, const char* help) {
        return FieldInfo{.name = name, .label = label, .symbol = symbol, .centre = 0, .help = help};
    };
    return {node("solution", "solution", "uₕ", "of the problem, in P1 on the adapted mesh"),
            node("solution_2", "solution, second component", "u₂ₕ", "in P1 on the adapted mesh"),
            node("solution_uniform", "solution, uniform mesh", "uₕ", "in P1 on the uniform mesh"),
            node("solution_2_uniform", "second component, uniform mesh", "u₂ₕ", "in P1 on the uniform mesh"),
            {.name = "width",
             .label = "cell width",
             .symbol = "hᵢ",
             .unit = "length",
             .place = FieldPlace::cell,
             .help = "distance between the nodes of a cell"}};
}

std::vector<std::vector<double>> IntervalMethod::fields(const ProblemData& data) {
    take_problem(data);
    std::vector<std::vector<double>> all(4);
    if (pde_)
        for (std::size_t k = 0; k < 2; ++k) {
            all[k] = component(solved().solution, k);
            all[2 + k] = component(solved_on_uniform().solution, k);
        }
    const std::vector<double>& x = positions().x;
    std::vector<double> width(x.size() - 1);
    for (std::size_t i = 0; i < width.size(); ++i) width[i] = x[i + 1] - x[i];
    all.push_back(std::move(width));
    return all;
}

} // namespace gaspard
