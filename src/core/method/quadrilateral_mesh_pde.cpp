#include "core/method/quadrilateral_mesh_pde.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/layer/layer_pde.hpp"
#include "core/layer/plane_solution_density.hpp"
#include "core/layer/square_mesh_pde.hpp"
#include "core/mesh/discretisation_as.hpp"
#include "core/method/interval_method.hpp"
#include "core/method/mesh_levels.hpp"
#include "core/method/solution_adapted.hpp"
#include "core/monitor/tensor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace gaspard {

namespace {

constexpr std::string_view quad_layout = "quadrilateral n=";
constexpr int cells_with_errors = 64;    ///< most for which method.reference = auto measures the errors
constexpr int cells_with_solution = 256; ///< most for which it solves the problem
constexpr int many_steps = 200;          ///< of Newton's method, after which it may not converge
constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// Where the densities are from.
enum class DensitySource { monitor, solution };

class QuadrilateralMeshPde final : public Method {
  public:
    QuadrilateralMeshPde(std::shared_ptr<const QuadrilateralDomain> domain, DensitySource source,
                         const Values& values)
        : domain_(std::move(domain)), source_(source) {
        configure(values);
    }

    void configure(const Values& values) override {
        levels_.configure(values, domain_->cells(), true);
        if (source_ == DensitySource::solution)
            configure_densities(values);
        else
            configure_equation(values);
        const std::string& reference = values.text("reference");
        measures_errors_ = why_without_errors(reference, domain_->cells()).empty();
        computes_solution_ = reference != "auto" || domain_->cells() <= cells_with_solution;
        solves_before_ = values.integer("inner_solves");
        next_.reset();
    }

    State initial_state() const override { return state_of(uniform(domain_->cells()).nodes()); }

    std::optional<State> adopt(const State& other, const Discretisation*) override {
        if (other.layout == layout()) return other; // also of a coarser mesh
        if (!other.layout.starts_with(quad_layout)) return std::nullopt;
        const Points parameters = parameters_of(other);
        State state = other;
        set(state, resampled_grid(parameters, cells_of(parameters), domain_->cells()));
        state.layout = layout();
        return state;
    }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override {
        levels_.begin();
        solves_ = 0;
        const Points parameters = parameters_of(state);
        SquareMeshPde at = uniform(cells_of(parameters));
        at.set_positions(parametric_ ? parameters : domain_->positions(parameters));
        Evaluation evaluation = look(data, std::move(at), stop);
        if (level() > 0 || source_ == DensitySource::solution) evaluation.ending = Ending::not_yet;
        return evaluation;
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token stop) override {
        const std::size_t level = levels_.next(this->level());
        std::optional<SquareMeshPde> at = std::exchange(next_, std::nullopt);
        GASPARD_CHECK(at.has_value());
        double part = part_;
        if (level != this->level()) {
            if (level > this->level()) {
                at = uniform(levels_.cells(level));
            } else {
                at->set_positions(nodes_, centres_); // of the iterate, whose next one is of no use
                at->refine();
            }
            advance(*at, data, stop);
            part = part_;
            solves_ = 0;
        }
        std::optional<SquareMeshNewton> newton;
        if (converges_ && level == 0 && level == this->level() && ++solves_ > solves_before_) {
            at->set_positions(nodes_, centres_); // Newton's step replaces the solve
            if (solves_ == solves_before_ + 1)
                if (auto nested = from_coarser_meshes(data, stop)) at = std::move(nested);
            newton = at->newton(densities_of(data, stop), stop);
        }
        Evaluation evaluation = look(data, std::move(*at), stop);
        state = state_of(nodes_);
        evaluation.step_size = newton ? newton->factor : part;
        evaluation.ending = levels_.ending(level);
        if (converges_ && level == 0) {
            const bool done = newton && newton->converged(0); // as far as rounding lets it
            evaluation.ending = done ? Ending::complete : Ending::by_criterion;
            if (samples_ == DensitySamples::degree_4 && solves_ > solves_before_ + many_steps &&
                evaluation.residual > 1e-6)
                evaluation.note =
                    "with densities of degree 4 the equations of thin layers may have no solution "
                    "near this mesh; method.samples = corners may help";
        }
        return evaluation;
    }

    const Points& positions() override {
        if (positions_.size() == 0) {
            const int n = domain_->cells(), own = cells_of(nodes_);
            const Points grid = own == n ? nodes_ : resampled_grid(nodes_, own, n);
            positions_ = parametric_ ? domain_->positions(grid) : grid;
        }
        return positions_;
    }

    std::vector<SeriesInfo> series() const override {
        std::vector<SeriesInfo> all = energy_error_series();
        all.push_back(level_series());
        return all;
    }

    std::vector<double> measures(const ProblemData& data) override {
        take_problem(data);
        if (!problem_ || !measures_errors_ || !is_solvable()) return {absent, absent, absent, absent};
        const Solved &here = solved(data.stop), &uniform = solved_on_uniform(data.stop);
        return {here.error.value_or(absent), absent, uniform.error.value_or(absent), absent};
    }

    std::vector<std::vector<double>> fields(const ProblemData& data) override {
        take_problem(data);
        std::vector<std::vector<double>> all(layer_fields().size());
        if (problem_ && computes_solution_ && is_solvable()) {
            all[0] = solved(data.stop).solution.values;
            all[2] = solved_on_uniform(data.stop).solution.values;
        }
        return all;
    }

  private:
    struct Solved {
        TriangleSolution solution;
        std::optional<double> error{};
    };

    void configure_equation(const Values& values) {
        const bool vertical = values.text("form") == "vertical";
        parametric_ = !vertical || !domain_->has_vertical_sides();
        form_ = vertical ? MeshPdeForm::one_direction : MeshPdeForm::componentwise;
        samples_ = values.text("samples") == "corners" ? DensitySamples::corners : DensitySamples::degree_4;
        converges_ = values.text("finish") == "converged";
    }
    void configure_densities(const Values& values) {
        if (levels_.cells(levels_.coarsest()) < 2)
            throw InputError("on a quadrilateral, method.start_cells must be at least 2");
        solution_options_ = solution_options(values);
        if (solution_options_.density == SolutionDensity::estimate)
            throw InputError("method.density = estimate is for intervals; on a quadrilateral, use arc-length "
                             "or curvature");
        form_ = MeshPdeForm::componentwise;
        parametric_ = true;
        converges_ = false;
    }

    /// One solve, for densities at the iterate.
    SquareMeshSolve advance(SquareMeshPde& at, const ProblemData& data, const std::stop_token& stop) {
        part_ = 1;
        if (source_ == DensitySource::monitor) return at.solve(densities_of(data, stop));
        take_problem(data);
        if (!problem_) throw InputError("method solution-adapted needs a problem to solve; set pde.type");
        const Points nodes = at.nodes(), centres = at.centres();
        const TriangleSolution solution =
            solve_fitted(*problem_, domain_->positions(nodes), at.cells(), stop);
        SquareMeshSolve solve =
            at.solve(plane_solution_densities(solution_options_, nodes, at.cells(), solution));
        const Points ahead = at.nodes(), centres_ahead = at.centres();
        while (is_inverted(at) && part_ > 1e-6) { // the next solution needs areas
            part_ /= 2;
            at.set_positions(between(nodes, ahead, part_), between(centres, centres_ahead, part_));
        }
        return solve;
    }
    /// The converged mesh of half as many cells, refined, from which columns with densities at corners need
    /// fewer steps than from the solves before; empty for others, and where a coarser mesh does not converge.
    std::optional<SquareMeshPde> from_coarser_meshes(const ProblemData& data, const std::stop_token& stop) {
        if (form_ != MeshPdeForm::one_direction || samples_ != DensitySamples::corners) return std::nullopt;
        std::size_t level = levels_.coarsest();
        if (level == 0) return std::nullopt;
        SquareMeshPde at = uniform(levels_.cells(level));
        const LayerDensities densities = densities_of(data, stop);
        for (std::int64_t i = 0; i < solves_before_; ++i) at.solve(densities);
        for (; level > 0; --level) {
            constexpr int most = 300;
            bool converged = false;
            for (int i = 0; i < most && !converged; ++i)
                converged = at.newton(densities, stop).converged(1e-8);
            if (!converged) return std::nullopt;
            at.refine();
        }
        return at;
    }
    bool is_inverted(const SquareMeshPde& at) const {
        return inverted_triangles(domain_->positions(at.nodes()), at.cells()) > 0;
    }
    static Points between(const Points& a, const Points& b, double part) {
        Points points(a.size());
        for (std::size_t i = 0; i < a.size(); ++i) points.set(i, (1 - part) * a[i] + part * b[i]);
        return points;
    }

    std::string layout() const { return std::string(quad_layout) + std::to_string(domain_->cells()); }
    /// States hold (s, t), whatever the form, which may change while a state stays.
    State state_of(const Points& nodes) const {
        State state{layout(), {{"s", {}}, {"t", {}}}};
        set(state, parametric_ ? nodes : domain_->parameters_at(nodes));
        return state;
    }
    static void set(State& state, const Points& parameters) {
        state.arrays[0].values = parameters.x;
        state.arrays[1].values = parameters.y;
    }
    static Points parameters_of(const State& state) {
        GASPARD_CHECK(state.layout.starts_with(quad_layout) && state.arrays.size() == 2);
        Points parameters(state.arrays[0].values.size());
        parameters.x = state.arrays[0].values, parameters.y = state.arrays[1].values;
        return parameters;
    }
    static int cells_of(const Points& nodes) {
        return static_cast<int>(std::lround(std::sqrt(static_cast<double>(nodes.size())))) - 1;
    }
    std::size_t level() const { return levels_.level_of(cells_of(nodes_)); }

    /// The uniform mesh: of the parameters, or of the quadrilateral.
    SquareMeshPde uniform(int cells) const {
        std::array<Vec3, 4> corners = SquareMeshPdeOptions{}.corners;
        if (!parametric_) {
            const Corners& c = domain_->corners();
            corners = {c[0], c[1], c[3], c[2]};
        }
        return {form_, samples_, corners, cells};
    }

    LayerDensities densities_of(const ProblemData& data, const std::stop_token& stop) const {
        return [this, &data, stop](const Points& at, std::span<double> first, std::span<double> second) {
            if (stop.stop_requested()) throw Interrupted(); // once per row of cells
            const Points x = parametric_ ? domain_->positions(at) : at;
            if (!data.tensor) {
                data.monitor->values(x, first);
                std::copy(first.begin(), first.end(), second.begin());
                return;
            }
            std::vector<SymmetricTensor> m(x.size());
            data.tensor->values(x, m);
            for (std::size_t i = 0; i < m.size(); ++i) first[i] = m[i].xx, second[i] = m[i].yy;
        };
    }

    /// Makes `at` the iterate and computes the next one.
    Evaluation look(const ProblemData& data, SquareMeshPde at, const std::stop_token& stop) {
        take_problem(data);
        nodes_ = at.nodes();
        centres_ = at.centres();
        positions_.resize(0);
        solved_.reset();
        const SquareMeshSolve solve = advance(at, data, stop);
        next_ = std::move(at);
        const double size = parametric_ ? 1 : longest_side(bounding_box(*domain_->control_points()));
        return {.residual = solve.update / size,
                .series = {static_cast<double>(level())},
                .inner_iterations = solve.inner_iterations};
    }

    void take_problem(const ProblemData& data) {
        if (data.pde == pde_values_ && data.pde_type == pde_type_) return;
        std::optional<TriangleProblem> made;
        if (data.pde) made = plane_pde(data.pde_type, *data.pde);
        if (made) { // the points of the rule miss the sides
            const Points& nodes = domain_->mesh()->nodes;
            std::vector<TriangleCoefficients> at(nodes.size());
            made->coefficients(nodes, at);
        }
        pde_values_ = data.pde;
        pde_type_ = data.pde_type;
        problem_ = std::move(made);
        solved_.reset();
        uniform_.reset();
    }

    /// Finite elements need triangles that are not inverted.
    bool is_solvable() { return inverted_triangles(positions(), domain_->cells()) == 0; }
    Solved solved_on(const Points& x, const std::stop_token& stop) const {
        return {solve_triangles(*problem_, x, domain_->cells(), 1, stop)};
    }
    void add_error(Solved& solved, const Points& x, const std::stop_token& stop) const {
        if (!measures_errors_ || solved.error) return;
        solved.error = reference_error(*problem_, x, domain_->cells(), solved.solution,
                                       solve_triangles(*problem_, x, domain_->cells(), 2, stop), stop);
    }
    const Solved& solved(const std::stop_token& stop) {
        if (!solved_) solved_ = solved_on(positions(), stop);
        add_error(*solved_, positions(), stop);
        return *solved_;
    }
    const Solved& solved_on_uniform(const std::stop_token& stop) {
        if (!uniform_) uniform_ = solved_on(domain_->mesh()->nodes, stop);
        add_error(*uniform_, domain_->mesh()->nodes, stop);
        return *uniform_;
    }

    std::shared_ptr<const QuadrilateralDomain> domain_;
    DensitySource source_;
    SolutionMeshOptions solution_options_;
    MeshLevels levels_;
    MeshPdeForm form_ = MeshPdeForm::componentwise;
    bool parametric_ = true; ///< the unknowns are (s, t), not positions
    DensitySamples samples_ = DensitySamples::degree_4;
    bool measures_errors_ = true, computes_solution_ = true, converges_ = true;
    std::int64_t solves_before_ = 0; ///< on the last mesh, before Newton's method
    std::int64_t solves_ = 0;        ///< made there
    // The iterate last evaluated, and the next one:
    Points nodes_, centres_, positions_;
    std::optional<SquareMeshPde> next_;
    double part_ = 1; ///< of the solve that led to next_; less where all of it would invert triangles
    std::shared_ptr<const Values> pde_values_; ///< of which problem_ was made
    std::string pde_type_;
    std::optional<TriangleProblem> problem_;
    std::optional<Solved> solved_, uniform_;
};

} // namespace

std::vector<ParameterRow> quadrilateral_rows() {
    return {
        {.key = "form",
         .label = "Form",
         .kind = ParameterKind::choice,
         .default_value = std::string("both"),
         .choices = {"both", "vertical"},
         .help =
             "on a quadrilateral: in both directions (29), or only from the lower to the upper side (28)"},
        {.key = "samples",
         .label = "Samples",
         .kind = ParameterKind::choice,
         .default_value = std::string("degree-4"),
         .choices = {"degree-4", "corners"},
         .help = "on a quadrilateral: where triangles sample M, as a polynomial of degree 4 or at their "
                 "corners, which is faster"}};
}

ParameterRow reference_row() {
    return {.key = "reference",
            .label = "Measure errors",
            .kind = ParameterKind::choice,
            .default_value = std::string("auto"),
            .choices = {"auto", "on", "off"},
            .help =
                "on a quadrilateral: the energy error of the solution, against one of order 2, which takes "
                "long on fine meshes; auto: up to 64 cells per side, and no solution beyond 256"};
}

std::string why_without_errors(const std::string& reference, int cells) {
    if (reference == "off") return "method.reference=off measures no errors; auto and on do";
    if (reference == "on" || cells <= cells_with_errors) return {};
    return "errors beyond " + std::to_string(cells_with_errors) +
           " cells per side are measured only with method.reference=on";
}

static std::unique_ptr<Method> make_method(const MethodContext& context, DensitySource source,
                                           const Values& values) {
    auto domain = discretisation_as<QuadrilateralDomain>(context.discretisation);
    return std::make_unique<QuadrilateralMeshPde>(std::move(domain), source, values);
}

std::unique_ptr<Method> quadrilateral_mesh_pde(const MethodContext& context, const Values& values) {
    return make_method(context, DensitySource::monitor, values);
}

std::unique_ptr<Method> quadrilateral_solution_adapted(const MethodContext& context, const Values& values) {
    return make_method(context, DensitySource::solution, values);
}

} // namespace gaspard
