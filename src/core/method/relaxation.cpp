// The relaxation method of McRae, Cotter, Budd, section 3.1:
//
//   <grad v, grad phi^{k+1}> = <grad v, grad phi^k> + dt <v, m det(I + sigma^k) - theta^k>       (3.7)
//
// sigma, x and theta follow from phi; see method/equation.hpp.
#include "core/method/equation.hpp"

namespace gaspard {

namespace {

class Relaxation final : public Method {
  public:
    Relaxation(std::unique_ptr<Equation> equation, const Values& values)
        : equation_(std::move(equation)), update_(equation_->unknowns()) {
        configure(values);
    }

    void configure(const Values& values) override { step_size_ = values.real_or_auto("step_size"); }
    void use_threads(int threads) override { equation_->use_threads(threads); }
    double other_cpu_seconds() const override { return equation_->other_cpu_seconds(); }

    State initial_state() const override { return equation_->initial_state(); }
    std::optional<State> adopt(const State& other, const Discretisation* of) override {
        return equation_->adopt(other, of);
    }

    Evaluation evaluate(const Monitor& monitor, const State& state, std::stop_token) override {
        return equation_->evaluate(monitor, equation_->potential(state));
    }

    Evaluation step(const Monitor& monitor, State& state, std::stop_token) override {
        auto& phi = equation_->potential(state);
        const double step_size = step_size_ ? *step_size_ : stable_step(equation_->ellipticity());
        equation_->direction(update_);
        for (std::size_t i = 0; i < phi.size(); ++i) phi[i] += step_size * update_[i];
        Evaluation evaluation = equation_->evaluate(monitor, phi);
        evaluation.step_size = step_size;
        return evaluation;
    }

    const Points& positions() override { return equation_->positions(); }
    std::vector<SeriesInfo> series() const override { return equation_->series(); }
    std::vector<double> measures(const Monitor& monitor) override { return equation_->measures(monitor); }

  private:
    std::unique_ptr<Equation> equation_;
    std::optional<double> step_size_; ///< none: as long as is stable, anew for every iterate
    std::vector<double> update_;
};

} // namespace

MethodType relaxation_method() {
    return {.name = "relaxation",
            .label = "Relaxation",
            .help = "an explicit step of the parabolic equation: robust, linear convergence",
            .rows = {{.key = "step_size",
                      .label = "Step size",
                      .symbol = "dt",
                      .kind = ParameterKind::real_or_auto,
                      .minimum = 1e-4,
                      .maximum = 10,
                      .scale = ParameterScale::logarithmic,
                      .default_value = std::string("auto"),
                      .help = "larger is faster until the iteration diverges; auto: as large as the present "
                              "mesh allows"}},
            .make = [](std::shared_ptr<const Discretisation> discretisation, const Values& values,
                       const Progress&, std::stop_token) -> std::unique_ptr<Method> {
                return std::make_unique<Relaxation>(make_equation(std::move(discretisation)), values);
            }};
}

std::vector<ParameterRow> common_method_rows() {
    return {
        {.key = "tolerance",
         .label = "Tolerance",
         .minimum = 1e-14,
         .maximum = 1,
         .scale = ParameterScale::logarithmic,
         .default_value = 1e-8,
         .help = "converged when the normalised residual is below"},
        {.key = "max_iterations",
         .label = "Iterations at most",
         .kind = ParameterKind::integer,
         .minimum = 0,
         .maximum = 1000000,
         .scale = ParameterScale::logarithmic,
         .default_value = std::int64_t{5000},
         .help = "the run ends as iteration-limit after so many"},
        {.key = "diagnostics_every",
         .label = "Diagnostics every",
         .kind = ParameterKind::integer,
         .minimum = 1,
         .maximum = 1000,
         .scale = ParameterScale::logarithmic,
         .default_value = std::int64_t{10},
         .help = "iterations between two measurements of equidistribution and cells; always for the last"}};
}

} // namespace gaspard
