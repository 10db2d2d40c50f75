// Meshes that are adapted to the computed solution, without knowledge of eps: on a quadrilateral as in
// method/quadrilateral_mesh_pde.hpp; on an interval
// (layer/solution_density.hpp): each step solves the problem in P1, with exponential fitting, and makes one
// step of the mesh PDE with densities from that solution. Meshes are refined as in method/mesh_levels.hpp.
// The monitor is not used but for diagnostics. The solution that is reported is Galerkin's.
#include "core/method/solution_adapted.hpp"

#include "core/base/error.hpp"
#include "core/layer/solution_density.hpp"
#include "core/mesh/discretisation_as.hpp"
#include "core/method/interval_iteration.hpp"
#include "core/method/quadrilateral_mesh_pde.hpp"

#include <utility>

namespace gaspard {

namespace {

class SolutionAdapted final : public IntervalIteration {
  public:
    SolutionAdapted(std::shared_ptr<const IntervalDomain> domain, const Values& values)
        : IntervalIteration(std::move(domain)) {
        configure(values);
    }

    void configure(const Values& values) override {
        levels().configure(values, domain().cells(), false);
        if (levels().cells(levels().coarsest()) < 4)
            throw InputError("method.start_cells must be at least 4, so that there are second derivatives");
        options_ = solution_options(values);
    }

    /// The densities are those of the mesh of the run only after the steps on coarser ones.
    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override {
        Evaluation evaluation = IntervalIteration::evaluate(data, state, stop);
        evaluation.ending = Ending::not_yet;
        return evaluation;
    }

  protected:
    std::vector<double> densities(const ProblemData& data, const std::vector<double>& mesh) override {
        look_at(data, mesh);
        if (!problem()) throw InputError("method solution-adapted needs a problem to solve; set pde.type");
        return solution_densities(options_, *problem(), mesh, solve_fitted(*problem(), mesh));
    }

  private:
    SolutionMeshOptions options_;
};

std::vector<ParameterRow> rows() {
    std::vector<ParameterRow> all = {
        {.key = "density",
         .label = "Density from",
         .kind = ParameterKind::choice,
         .default_value = std::string("arc-length"),
         .choices = {"arc-length", "curvature", "estimate"},
         .help = "arc-length: of the solution, finds layers at both ends; curvature: its second derivative; "
                 "estimate, on intervals: the energy norm of the error"},
        {.key = "smoothing",
         .label = "Smoothing",
         .kind = ParameterKind::integer,
         .minimum = 0,
         .maximum = 20,
         .default_value = std::int64_t{2},
         .help = "how often the densities of neighbouring cells are averaged"}};
    for (ParameterRow& row : MeshLevels::rows(8, 10, 10)) all.push_back(std::move(row));
    all.push_back(reference_row());
    return all;
}

} // namespace

SolutionMeshOptions solution_options(const Values& values) {
    SolutionMeshOptions options;
    const std::string& density = values.text("density");
    options.density = density == "curvature"  ? SolutionDensity::curvature
                      : density == "estimate" ? SolutionDensity::estimate
                                              : SolutionDensity::arc_length;
    options.smoothing = static_cast<int>(values.integer("smoothing"));
    return options;
}

MethodType solution_adapted_method() {
    return {.name = "solution-adapted",
            .label = "Solution-adapted",
            .help = "alternates the solution of the problem with steps of the mesh, from a coarse mesh on",
            .rows = rows(),
            .residual = {.name = "residual",
                         .label = "Mesh PDE residual",
                         .symbol = "‖res‖",
                         .scale = ParameterScale::logarithmic,
                         .help = "on an interval the L2 norm of the residual, on a quadrilateral the largest "
                                 "change that the next solve makes"},
            .fields = layer_fields(),
            .colour = "solution",
            .make = [](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
                auto domain = discretisation_as<IntervalDomain>(context.discretisation);
                return std::make_unique<SolutionAdapted>(std::move(domain), values);
            }};
}

} // namespace gaspard
