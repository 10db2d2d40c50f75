// The methods of Bahari, Habbal, Ratnani, Sonnendruecker (2024): the fixed-point iteration phi <- T(phi) of
// method/bfo.hpp in the standard form, (4.2) to (4.5), and in the mixed form, (6.1) to (6.9).
//
// As in the paper, the iteration ends when the increment is small: the L2 norm of the mean-free last
// increment of phi; at the start, that of the next increment. The residual is that of
// method/spline_equation.hpp, in the mixed form with its own test functions:
//
//   |r| / |<v, d>|,   r_v = <div Psi - s G(Psi), v>
//
// From the identity map, the iteration starts on 16 cells per direction, in the cube 8 (multilevel start),
// and continues on finer meshes by knot insertion (remark 4.1). One iteration is one update on any level.
#include "core/base/check.hpp"
#include "core/linear/reduce.hpp"
#include "core/mesh/discretisation_as.hpp"
#include "core/method/method.hpp"
#include "core/method/patch_form.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t fewest_cells(std::size_t dimension) { // of the coarsest mesh, per direction
    return dimension == 2 ? 16 : 8;
}
constexpr double coarse_increment = 1e-5;   // for the increment, on all levels except the finest
constexpr int most_coarse_iterations = 100; // maximum on each of these levels

/// Its column has the name that the other methods give to the same constant.
SeriesInfo sigma_series() {
    return {.name = "theta",
            .label = "Constant σ",
            .symbol = "σ",
            .help = "the factor that gives f the integral of the Jacobian",
            .column = false,
            .bounded = true};
}

SeriesInfo increment_series() {
    return {.name = "increment",
            .label = "Increment",
            .symbol = "‖Δφ‖",
            .scale = ParameterScale::logarithmic,
            .help = "L² norm of the last increment of φ, which ends the iteration"};
}

template <std::size_t D>
class Picard final : public Method {
    using Bfo = BfoIteration<D>;

  public:
    Picard(std::shared_ptr<const TensorDomain<D>> domain, Formulation formulation, const Values& values)
        : domain_(std::move(domain)), formulation_(formulation) {
        levels_.push_back(make_level(domain_->cells()));
        configure(values);
    }

    void configure(const Values& values) override {
        tolerance_ = values.real("tolerance");
        multilevel_ = values.text("start") == "multilevel";
        measure_ = measure_of(values);
        for (Level& level : levels_) level.form->set_measure(measure_);
        const double shift = formulation_ == Formulation::standard ? values.real("penalty") : 0;
        if (shift == shift_) return;
        shift_ = shift;
        for (Level& level : levels_) level.bfo = Bfo(level.form->form(), shift_, threads_);
        next_.clear();
        load_of_whole_.clear();
    }

    State initial_state() const override {
        return {levels_[0].form->layout(),
                {{"phi", std::vector<double>(levels_[0].form->form()->unknowns(), 0.0)}}};
    }

    std::optional<State> adopt(const State& other, const Discretisation*) override {
        if (other.arrays.size() != 1 || other.arrays[0].name != "phi") return std::nullopt;
        auto phi = levels_[0].form->adopt(other.layout, other.arrays[0].values);
        if (phi.empty()) return std::nullopt;
        return State{levels_[0].form->layout(), {{"phi", std::move(phi)}}};
    }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token) override {
        level_ = level_of(state);
        const auto& phi = state.arrays[0].values;
        at_start_ = level_ == 0 && state == initial_state();
        whole_.resize(phi.size());
        levels_[level_].form->add_identity(phi, whole_);
        load_of_whole_.clear();
        if (level_ == 0) {
            iterate(data);
            increment_ = next_increment_;
            return report();
        }
        // Report the residual on the finest mesh; a small residual on a coarser one must not end the run.
        const std::size_t coarse = level_;
        const std::vector<double> of_state = whole_;
        go_to(0);
        iterate(data);
        increment_ = next_increment_;
        const Evaluation evaluation = report();
        level_ = coarse;
        whole_ = of_state;
        next_.clear();
        load_of_whole_.clear();
        return evaluation;
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token) override {
        GASPARD_CHECK(level_of(state) == level_);
        if (std::exchange(at_start_, false) && multilevel_) go_to_coarsest(data);
        if (next_.empty()) iterate(data);
        const std::size_t level_of_update = level_;
        increment_ = next_increment_;
        whole_.swap(next_);
        load_of_whole_ = load_;
        iterate(data);
        Evaluation evaluation = report(level_of_update);
        bool late = ++iterations_here_ >= most_coarse_iterations;
        // Skips levels that are already solved: a coarser level must not end the run.
        while (level_ > 0 && (late || increment_ < std::max(coarse_increment, tolerance_))) {
            go_to(level_ - 1);
            iterate(data);
            increment_ = next_increment_;
            late = false;
            evaluation = report(level_of_update);
            evaluation.note = "continuing on " + std::to_string(levels_[level_].form->cells()) + " cells";
        }
        const MappedForm<D>& here = *levels_[level_].form;
        state = {here.layout(), {{"phi", here.without_identity(whole_)}}};
        evaluation.step_size = 1;
        return evaluation;
    }

    const Points& positions() override {
        levels_[level_].form->positions(whole_, positions_);
        return positions_;
    }

    std::vector<SeriesInfo> series() const override {
        std::vector<SeriesInfo> all = patch_series(D);
        all.insert(all.begin(), {sigma_series(), increment_series(), level_series()});
        return all;
    }
    std::vector<double> measures(const ProblemData& data) override {
        return values_of(levels_[level_].form->measure(*data.monitor, whole_), D);
    }
    bool knows_map() const override { return true; }
    std::vector<std::uint32_t> folded_cells() override { return levels_[level_].form->folded_cells(whole_); }
    void use_threads(int threads) override {
        const auto wanted = static_cast<std::size_t>(threads);
        if (D == 2 || wanted == threads_) return; // sums of the square are too short to be shared
        threads_ = wanted;
        for (Level& level : levels_) level.bfo = Bfo(level.form->form(), shift_, threads_);
        load_of_whole_.clear();
    }
    double other_cpu_seconds() const override {
        double sum = 0;
        for (const Level& level : levels_) sum += level.bfo.other_cpu_seconds();
        return sum;
    }

  private:
    struct Level {
        std::unique_ptr<MappedForm<D>> form;
        Bfo bfo;
        double unit; ///< |<v, d>|
    };
    Level make_level(std::size_t cells) const {
        auto form = std::make_unique<MappedForm<D>>(domain_, formulation_, cells);
        form->set_measure(measure_);
        Bfo bfo(form->form(), shift_, threads_);
        const double unit = norm_of_divergence(*form->form());
        return {std::move(form), std::move(bfo), unit};
    }
    std::size_t level_of(const State& state) const {
        for (std::size_t level = 0; level < levels_.size(); ++level)
            if (levels_[level].form->layout() == state.layout) {
                GASPARD_CHECK(state.arrays.size() == 1 &&
                              state.arrays[0].values.size() == levels_[level].form->form()->unknowns());
                return level;
            }
        check_failed("the state is of this method");
    }
    /// Computes next_, next_increment_, load_ and residual_.
    void iterate(const ProblemData& data) {
        Level& here = levels_[level_];
        const TensorSource<D> source = here.form->source(*data.monitor);
        sigma_ = data.unit * source.sigma();
        next_.resize(whole_.size());
        here.bfo.iterate(source, whole_, next_);
        load_.assign(here.bfo.load().begin(), here.bfo.load().end());
        scratch_.resize(whole_.size());
        for (std::size_t i = 0; i < whole_.size(); ++i) scratch_[i] = next_[i] - whole_[i];
        next_increment_ = here.form->form()->norm_without_mean(scratch_);
        if (load_of_whole_.empty())
            here.bfo.residual(whole_, next_, scratch_);
        else // the same, without the products with A
            for (std::size_t i = 0; i < whole_.size(); ++i) scratch_[i] = load_[i] - load_of_whole_[i];
        residual_ = std::sqrt(dot(scratch_, scratch_)) / here.unit;
    }
    /// Transfers the map to another level.
    void go_to(std::size_t level) {
        const MappedForm<D>&from = *levels_[level_].form, &to = *levels_[level].form;
        const auto phi = to.adopt(from.layout(), from.without_identity(whole_));
        whole_.resize(phi.size());
        to.add_identity(phi, whole_);
        load_of_whole_.clear();
        level_ = level;
        iterations_here_ = 0;
    }
    Evaluation report(std::size_t level_of_update = 0) const {
        return {.residual = residual_, .series = {sigma_, increment_, static_cast<double>(level_of_update)}};
    }

    void go_to_coarsest(const ProblemData& data) {
        while (levels_.back().form->cells() % 2 == 0 && levels_.back().form->cells() / 2 >= fewest_cells(D))
            levels_.push_back(make_level(levels_.back().form->cells() / 2));
        if (levels_.size() == 1) return;
        level_ = levels_.size() - 1;
        iterations_here_ = 0;
        whole_ = levels_[level_].form->form()->identity();
        load_of_whole_.clear();
        iterate(data);
    }

    std::shared_ptr<const TensorDomain<D>> domain_;
    Formulation formulation_;
    std::vector<Level> levels_; ///< the first is the finest; the others are made when needed
    Measure measure_ = Measure::parameter;
    double shift_ = 0, tolerance_ = 0;
    std::size_t threads_ = 1;
    bool multilevel_ = true;
    // Results for the state last evaluated:
    std::size_t level_ = 0;
    int iterations_here_ = 0;
    bool at_start_ = false;
    std::vector<double> whole_, next_;         ///< Phi; T(Phi), or empty
    std::vector<double> load_, load_of_whole_; ///< of the Poisson problems for T(Phi) and Phi; or empty
    std::vector<double> scratch_;
    double residual_ = 0, sigma_ = 0;
    double increment_ = 0, next_increment_ = 0; ///< that led to Phi, that leads to T(Phi)
    Points positions_;
};

MethodType picard_type(Formulation formulation, std::string name, std::string label, std::string help) {
    std::vector<ParameterRow> rows = {
        {.key = "start",
         .label = "Start",
         .kind = ParameterKind::choice,
         .default_value = std::string("multilevel"),
         .choices = {"multilevel", "identity"},
         .help = "multilevel: start on the coarsest mesh and refine; identity: start on the finest mesh"}};
    if (formulation == Formulation::standard)
        rows.push_back(
            {.key = "penalty",
             .label = "Penalty",
             .symbol = "ε",
             .minimum = 0,
             .maximum = 1e-2,
             .default_value = 0.0,
             .help = "penalty of the mean of φ, 10⁻⁸ in the paper; 0 eliminates the mean exactly"});
    return {
        .name = std::move(name),
        .label = std::move(label),
        .help = std::move(help),
        .rows = std::move(rows),
        .criterion = increment_series().name,
        .make = [formulation](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
            return std::make_unique<Picard<2>>(discretisation_as<SplineDomain>(context.discretisation),
                                               formulation, values);
        }};
}

} // namespace

MethodType picard_method() {
    return picard_type(
        Formulation::standard, "picard", "Picard",
        "the fixed-point iteration of Benamou, Froese and Oberman: one Poisson problem per step");
}

MethodType picard_mixed_method() {
    return picard_type(
        Formulation::mixed, "picard-mixed", "Picard, mixed",
        "the same iteration in mixed form, with the map as unknown; boundaries are preserved exactly");
}

MethodMaker picard_in_solids(bool mixed) {
    return [mixed](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
        return std::make_unique<Picard<3>>(discretisation_as<SolidDomain>(context.discretisation),
                                           mixed ? Formulation::mixed : Formulation::standard, values);
    };
}

} // namespace gaspard
