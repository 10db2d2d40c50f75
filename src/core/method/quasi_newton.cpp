// The quasi-Newton method of McRae, Cotter, Budd, section 3.2, failures included: the linearisation (3.10),
// which leaves out how m changes with the map,
//
//   -<v, m cof(I + sigma^k) : dsigma> + dtheta <v, 1> = r,     phi^{k+1} = phi^k + s dphi
//
// sigma is eliminated exactly and dtheta kept (without it (3.10) is inconsistent); GMRES with the scaled
// Laplacian as preconditioner, where the paper has the Riesz map of the mixed system. s makes the l2 norm of
// the residual small, by five secant steps (Brune, Knepley, Smith, Tu, 2015). Nothing guards convexity.
#include "core/linear/gmres.hpp"
#include "core/method/equation.hpp"

#include <cmath>

namespace gaspard {

namespace {

constexpr double tolerance = 1e-5; ///< of the linear solver
constexpr int most_inner = 120;
constexpr std::size_t memory = 30; ///< of GMRES
constexpr int searches = 5;        ///< inner steps of the line search
constexpr double least_step = 1e-12, longest_step = 1e8;

class QuasiNewton final : public Method {
  public:
    explicit QuasiNewton(std::unique_ptr<Equation> equation)
        : equation_(std::move(equation)), gmres_(equation_->unknowns(), memory),
          update_(equation_->unknowns()), before_(update_) {}

    void configure(const Values&) override {}
    void use_threads(int threads) override { equation_->use_threads(threads); }
    double other_cpu_seconds() const override { return equation_->other_cpu_seconds(); }
    State initial_state() const override { return equation_->initial_state(); }
    std::optional<State> adopt(const State& other, const Discretisation* of) override {
        return equation_->adopt(other, of);
    }
    const Points& positions() override { return equation_->positions(); }
    std::vector<SeriesInfo> series() const override { return equation_->series(); }
    std::vector<double> measures(const Monitor& monitor) override { return equation_->measures(monitor); }

    Evaluation evaluate(const Monitor& monitor, const State& state, std::stop_token) override {
        return now_ = equation_->evaluate(monitor, equation_->potential(state));
    }

    Evaluation step(const Monitor& monitor, State& state, std::stop_token stop) override {
        auto& phi = equation_->potential(state);
        equation_->linearise(monitor, Equation::Linearised::frozen_monitor);
        const auto solved = gmres_.solve([&](auto v, auto out) { equation_->derivative(v, out); },
                                         [&](auto v, auto out) { equation_->precondition(v, out); },
                                         equation_->residual(), update_, {tolerance, most_inner}, stop);
        before_ = phi;
        const double length = stop.stop_requested() ? 0 : search(monitor, phi);
        now_ = at(monitor, phi, length);
        now_.step_size = length;
        now_.inner_iterations = solved.iterations;
        if (equation_->ellipticity().convexity <= 0) now_.note = "the map has lost its convexity";
        if (!solved.converged && !stop.stop_requested())
            now_.note += std::string(now_.note.empty() ? "" : "; ") + "the linear solver stagnates";
        return now_;
    }

  private:
    Evaluation at(const Monitor& monitor, std::vector<double>& phi, double length) {
        for (std::size_t i = 0; i < phi.size(); ++i) phi[i] = before_[i] + length * update_[i];
        return equation_->evaluate(monitor, phi);
    }

    /// Secants for the derivative of |r|^2 along the line, from values at both ends and in the middle.
    double search(const Monitor& monitor, std::vector<double>& phi) {
        const auto squared = [&](double length) {
            const double residual = at(monitor, phi, length).residual;
            return residual * residual;
        };
        double old = 0, length = 1, at_old = now_.residual * now_.residual;
        for (int i = 0; i < searches; ++i) {
            const double at_middle = squared((length + old) / 2), at_length = squared(length);
            const double across = length - old;
            const double slope = (3 * at_length - 4 * at_middle + at_old) / across;
            const double slope_old = (-3 * at_old + 4 * at_middle - at_length) / across;
            const double curvature = (slope - slope_old) / across;
            // Of a hill rather than a valley, away from the top.
            double next = length + (curvature > 0 ? -slope : slope) / curvature;
            if (next < least_step) next = (length + old) / 2;
            if (!std::isfinite(next) || next > longest_step) break;
            old = length, at_old = at_length, length = next;
        }
        return length;
    }

    std::unique_ptr<Equation> equation_;
    Gmres gmres_;
    std::vector<double> update_, before_;
    Evaluation now_;
};

} // namespace

MethodType quasi_newton_method() {
    return {.name = "quasi-newton",
            .label = "Quasi-Newton",
            .help = "the paper's linearisation with an l2 line search: far fewer iterations than the "
                    "relaxation, but it fails for harsh monitors",
            .rows = {},
            .make = [](std::shared_ptr<const Discretisation> discretisation, const Values&, const Progress&,
                       std::stop_token) -> std::unique_ptr<Method> {
                return std::make_unique<QuasiNewton>(make_equation(std::move(discretisation)));
            }};
}

} // namespace gaspard
