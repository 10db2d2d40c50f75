// Meshes of an interval that are adapted to the computed solution, without knowledge of eps
// (layer/solution_density.hpp): each step solves the problem in P1 and makes one step of the mesh PDE with
// densities from that solution. Meshes are refined as in method/mesh_levels.hpp. The monitor is not used but
// for diagnostics.
#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/layer/solution_density.hpp"
#include "core/method/interval_method.hpp"
#include "core/method/mesh_levels.hpp"

#include <utility>

namespace gaspard {

namespace {

class SolutionAdapted final : public IntervalMethod {
  public:
    SolutionAdapted(std::shared_ptr<const IntervalDomain> domain, const Values& values)
        : IntervalMethod(std::move(domain)) {
        configure(values);
    }

    void configure(const Values& values) override {
        levels_.configure(values, domain().cells(), false);
        if (levels_.cells(levels_.coarsest()) < 4)
            throw InputError("method.start_cells must be at least 4, so that there are second derivatives");
        const std::string& density = values.text("density");
        options_.density = density == "curvature"  ? SolutionDensity::curvature
                           : density == "estimate" ? SolutionDensity::estimate
                                                   : SolutionDensity::arc_length;
        options_.smoothing = static_cast<int>(values.integer("smoothing"));
    }

    std::vector<SeriesInfo> series() const override {
        std::vector<SeriesInfo> all = IntervalMethod::series();
        all.push_back(level_series());
        return all;
    }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token) override {
        levels_.begin();
        Evaluation evaluation = look(data, mesh_of(state));
        evaluation.ending = Ending::not_yet;
        return evaluation;
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token) override {
        const std::size_t level = levels_.next(this->level());
        if (level != this->level())
            look(data, level > this->level()
                           ? uniform_interval(domain().interval(), levels_.cells(level))
                           : resampled_interval(x(), static_cast<std::size_t>(levels_.cells(level))));
        mesh_of(state) = next_interval_mesh(densities_, domain().interval());
        Evaluation evaluation = look(data, mesh_of(state));
        evaluation.step_size = 1;
        evaluation.ending = levels_.ending(level);
        return evaluation;
    }

  private:
    std::size_t level() const { return levels_.level_of(static_cast<int>(x().size()) - 1); }

    Evaluation look(const ProblemData& data, const std::vector<double>& mesh) {
        look_at(data, mesh);
        if (!problem()) throw InputError("method solution-adapted needs a problem to solve; set pde.type");
        densities_ = solution_densities(options_, *problem(), x(), solve_interval(*problem(), x(), 1));
        double mass = 0;
        for (std::size_t i = 0; i < densities_.size(); ++i) mass += densities_[i] * (x()[i + 1] - x()[i]);
        return {.residual = interval_residual(densities_, x()) / mass,
                .series = {static_cast<double>(level())}};
    }

    MeshLevels levels_;
    SolutionMeshOptions options_;
    std::vector<double> densities_;
};

std::vector<ParameterRow> rows() {
    std::vector<ParameterRow> all = {
        {.key = "density",
         .label = "Density from",
         .kind = ParameterKind::choice,
         .default_value = std::string("arc-length"),
         .choices = {"arc-length", "curvature", "estimate"},
         .help = "arc-length: of the solution, finds layers at both ends; curvature: its second derivative; "
                 "estimate: the energy norm of the error"},
        {.key = "smoothing",
         .label = "Smoothing",
         .kind = ParameterKind::integer,
         .minimum = 0,
         .maximum = 20,
         .default_value = std::int64_t{2},
         .help = "how often the densities of neighbouring cells are averaged"}};
    for (ParameterRow& row : MeshLevels::rows(8, 10, 10)) all.push_back(std::move(row));
    return all;
}

} // namespace

MethodType solution_adapted_method() {
    return {
        .name = "solution-adapted",
        .label = "Solution-adapted",
        .help = "alternates the solution of the problem with steps of the mesh, from a coarse mesh on",
        .rows = rows(),
        .residual = {.name = "residual",
                     .label = "Mesh PDE residual",
                     .symbol = "‖res‖",
                     .scale = ParameterScale::logarithmic,
                     .help = "L2 norm of the residual of the mesh PDE, for the densities of the solution"},
        .fields = layer_fields(),
        .make = [](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
            auto domain = std::dynamic_pointer_cast<const IntervalDomain>(context.discretisation);
            GASPARD_CHECK(domain != nullptr); // guaranteed by the capability table
            return std::make_unique<SolutionAdapted>(std::move(domain), values);
        }};
}

} // namespace gaspard
