// The quasi-Newton method of McRae, Cotter, Budd, section 3.2, with the linearisation (3.10), which neglects
// the derivative of m with respect to the map:
//
//   -<v, m cof(I + sigma^k) : dsigma> + dtheta <v, 1> = r_v,     phi^{k+1} = phi^k + s dphi
//
// sigma is eliminated exactly, and dtheta is kept as an unknown; without it, (3.10) is inconsistent. The
// linear solver is GMRES, preconditioned by the scaled Laplacian; the paper uses the Riesz map of the mixed
// system. The line search for s reduces the l2 norm of the residual by five secant steps (Brune, Knepley,
// Smith, Tu, 2015). As in the paper, convexity is not enforced, and the method fails for strong monitors.
#include "core/linear/gmres.hpp"
#include "core/method/nonlinear_problem.hpp"

#include <cmath>

namespace gaspard {

namespace {

constexpr double linear_tolerance = 1e-5; ///< tolerance of the linear solver
constexpr int most_linear_steps = 120;
constexpr std::size_t linear_restart = 30; ///< restart length of GMRES
constexpr int searches = 5;                ///< secant steps of the line search
constexpr double least_step = 1e-12, longest_step = 1e8;

class QuasiNewton final : public Method {
  public:
    explicit QuasiNewton(std::unique_ptr<NonlinearProblem> problem)
        : problem_(std::move(problem)), gmres_(problem_->size(), linear_restart), update_(problem_->size()),
          before_(update_) {}

    void configure(const Values&) override {}
    void use_threads(int threads) override { problem_->use_threads(threads); }
    double other_cpu_seconds() const override { return problem_->other_cpu_seconds(); }
    State initial_state() const override { return problem_->state_of(problem_->start()); }
    std::optional<State> adopt(const State& other, const Discretisation* of) override {
        return problem_->adopt(other, of);
    }
    const Points& positions() override { return problem_->positions(); }
    std::vector<SeriesInfo> series() const override { return problem_->series(); }
    std::vector<double> measures(const ProblemData& data) override { return problem_->measures(data); }
    bool knows_map() const override { return problem_->knows_map(); }
    std::vector<std::uint32_t> folded_cells() override { return problem_->folded_cells(); }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token) override {
        return now_ = problem_->evaluate(data, problem_->unknowns(state));
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token stop) override {
        auto& u = problem_->unknowns(state);
        problem_->linearise(data, NonlinearProblem::Linearised::frozen_monitor);
        const auto solved =
            gmres_.solve([&](auto v, auto out) { problem_->derivative(v, out); },
                         [&](auto v, auto out) { problem_->precondition(v, out); }, problem_->residual(),
                         update_, {linear_tolerance, most_linear_steps}, stop);
        before_ = u;
        const double length = stop.stop_requested() ? 0 : search(data, u);
        now_ = at(data, u, length);
        now_.step_size = length;
        now_.inner_iterations = solved.iterations;
        if (problem_->shape().admissibility <= 0) now_.note = "the map is no longer convex";
        if (!solved.converged && !stop.stop_requested())
            now_.note += std::string(now_.note.empty() ? "" : "; ") + "the linear solver did not converge";
        return now_;
    }

  private:
    Evaluation at(const ProblemData& data, std::vector<double>& u, double length) {
        for (std::size_t i = 0; i < u.size(); ++i) u[i] = before_[i] + length * update_[i];
        return problem_->evaluate(data, u);
    }

    /// Secant method for the zero of d|r|^2/ds; derivatives are finite differences of the values at both ends
    /// and at the midpoint of the interval.
    double search(const ProblemData& data, std::vector<double>& u) {
        const auto squared = [&](double length) {
            const double residual = at(data, u, length).residual;
            return residual * residual;
        };
        double old = 0, length = 1, at_old = now_.residual * now_.residual;
        for (int i = 0; i < searches; ++i) {
            const double at_middle = squared((length + old) / 2), at_length = squared(length);
            const double across = length - old;
            const double slope = (3 * at_length - 4 * at_middle + at_old) / across;
            const double slope_old = (-3 * at_old + 4 * at_middle - at_length) / across;
            const double curvature = (slope - slope_old) / across;
            // For negative curvature (a maximum), step in the direction of decrease.
            double next = length + (curvature > 0 ? -slope : slope) / curvature;
            if (next < least_step) next = (length + old) / 2;
            if (!std::isfinite(next) || next > longest_step) break;
            old = length, at_old = at_length, length = next;
        }
        return length;
    }

    std::unique_ptr<NonlinearProblem> problem_;
    Gmres gmres_;
    std::vector<double> update_, before_;
    Evaluation now_;
};

} // namespace

MethodType quasi_newton_method() {
    return {.name = "quasi-newton",
            .label = "Quasi-Newton",
            .help = "the linearisation of the paper with an l2 line search: far fewer iterations than the "
                    "relaxation, but it fails for strong monitors",
            .rows = {},
            .make = [](const MethodContext& context, const Values&) -> std::unique_ptr<Method> {
                return std::make_unique<QuasiNewton>(context.problem());
            }};
}

} // namespace gaspard
