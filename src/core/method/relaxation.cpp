// The relaxation method of McRae, Cotter, Budd, section 3.1:
//
//   <grad v, grad phi^{k+1}> = <grad v, grad phi^k> + dt <v, m det(I + sigma^k) - theta^k>       (3.7)
//
// with sigma, x and theta computed from phi; see method/monge_ampere.hpp.
#include "core/method/nonlinear_problem.hpp"

namespace gaspard {

namespace {

class Relaxation final : public Method {
  public:
    Relaxation(std::unique_ptr<NonlinearProblem> problem, const Values& values)
        : problem_(std::move(problem)), update_(problem_->size()) {
        configure(values);
    }

    void configure(const Values& values) override { step_size_ = values.real_or_auto("step_size"); }
    void use_threads(int threads) override { problem_->use_threads(threads); }
    double other_cpu_seconds() const override { return problem_->other_cpu_seconds(); }

    State initial_state() const override { return problem_->state_of(problem_->start()); }
    std::optional<State> adopt(const State& other, const Discretisation* of) override {
        return problem_->adopt(other, of);
    }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token) override {
        return problem_->evaluate(data, problem_->unknowns(state));
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token) override {
        auto& u = problem_->unknowns(state);
        const double unit = problem_->step_unit(data);
        const double step_size = step_size_ ? *step_size_ * unit : problem_->shape().stable_step;
        problem_->direction(update_);
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += step_size * update_[i];
        Evaluation evaluation = problem_->evaluate(data, u);
        evaluation.step_size = step_size / unit;
        return evaluation;
    }

    const Points& positions() override { return problem_->positions(); }
    std::vector<SeriesInfo> series() const override { return problem_->series(); }
    std::vector<double> measures(const ProblemData& data) override { return problem_->measures(data); }
    bool knows_map() const override { return problem_->knows_map(); }
    std::vector<std::uint32_t> folded_cells() override { return problem_->folded_cells(); }

  private:
    std::unique_ptr<NonlinearProblem> problem_;
    std::optional<double> step_size_; ///< nullopt: the stable step of each iterate
    std::vector<double> update_;
};

} // namespace

MethodType relaxation_method() {
    return {
        .name = "relaxation",
        .label = "Relaxation",
        .help = "explicit time steps of a parabolic equation; robust, converges linearly",
        .rows = {{.key = "step_size",
                  .label = "Step size",
                  .symbol = "Δt",
                  .kind = ParameterKind::real_or_auto,
                  .minimum = 1e-4,
                  .maximum = 10,
                  .scale = ParameterScale::logarithmic,
                  .default_value = std::string("auto"),
                  .help = "larger is faster until the iteration diverges; in units of 1/m; auto: the largest "
                          "stable step for the current mesh",
                  .remedy = std::string("auto")}},
        .make = [](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
            return std::make_unique<Relaxation>(context.problem(), values);
        }};
}

Values default_values(const MethodType& type, const std::vector<ParameterRow>& on_domain) {
    auto rows = type.rows;
    rows.insert(rows.end(), on_domain.begin(), on_domain.end());
    for (auto& row : as_details(common_method_rows())) {
        if (row.key == "tolerance" && type.criterion != type.residual.name)
            row.help = "the run converges when the " + type.criterion + " is below this value";
        rows.push_back(std::move(row));
    }
    return Values("method", std::move(rows));
}

std::vector<ParameterRow> common_method_rows() {
    return {
        {.key = "tolerance",
         .label = "Tolerance",
         .minimum = 1e-14,
         .maximum = 1,
         .scale = ParameterScale::logarithmic,
         .default_value = 1e-8,
         .help = "the run converges when the normalised residual is below this value"},
        {.key = "max_iterations",
         .label = "Max. iterations",
         .kind = ParameterKind::integer,
         .minimum = 0,
         .maximum = 1000000,
         .scale = ParameterScale::logarithmic,
         .default_value = std::int64_t{5000},
         .help = "the run ends with status iteration-limit after this number of iterations"},
        {.key = "diagnostics_every",
         .label = "Diagnostics interval",
         .kind = ParameterKind::integer,
         .minimum = 1,
         .maximum = 1000,
         .scale = ParameterScale::logarithmic,
         .default_value = std::int64_t{10},
         .help =
             "iterations between evaluations of equidistribution and Jacobians; the last iterate is always "
             "evaluated"},
        {.key = "diagnostics",
         .label = "Diagnostics",
         .kind = ParameterKind::choice,
         .default_value = std::string("full"),
         .choices = {"full", "geometry", "none"},
         .help = "full: equidistribution and Jacobians; geometry: Jacobians, without further evaluations of "
                 "the monitor; none: only tangled cells, of the last iterate"},
        {.key = "interpolation",
         .label = "Interpolation errors",
         .kind = ParameterKind::boolean,
         .default_value = true,
         .help =
             "measures how well the uniform and the adapted mesh interpolate the monitor, or the function "
             "from which it is made; needs diagnostics = full"},
        {.key = "cell_quality",
         .label = "Cell quality",
         .kind = ParameterKind::boolean,
         .default_value = false,
         .help =
             "measures aspect ratio, skewness, orthogonality and alignment with grad m whenever the mesh is "
             "measured, for plots and history.csv; needs diagnostics = full"}};
}

} // namespace gaspard
