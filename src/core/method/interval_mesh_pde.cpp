// The mesh PDE (rho(x) x')' = 0 on an interval, by the iterations of Hill, Madden (2021): Algorithm 1 starts
// on the mesh of the run, Algorithm 2 on a coarse one, with some solves on every mesh before it is refined.
//
// An iteration is one solve of (15). On the last mesh they go on until the residual (16) is below
// method.tolerance, or as often as method.final_solves says; or shots solve the discrete equations to
// rounding (layer/interval_shooting.hpp), which the iteration does not for thin layers.
#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/layer/interval_shooting.hpp"
#include "core/mesh/discretisation_as.hpp"
#include "core/method/interval_iteration.hpp"
#include "core/method/quadrilateral_mesh_pde.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

constexpr double equal_shares = 1e-12; ///< relative difference of the shares of a mesh that has converged

class IntervalMeshPde final : public IntervalIteration {
  public:
    IntervalMeshPde(std::shared_ptr<const IntervalDomain> domain, const Values& values)
        : IntervalIteration(std::move(domain)) {
        configure(values);
    }

    void configure(const Values& values) override {
        levels().configure(values, domain().cells(), false);
        normalised_ = values.boolean("normalised");
        converges_ = values.text("finish") == "converged";
        shooting_.reset();
    }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override {
        shooting_.reset();
        return IntervalIteration::evaluate(data, state, stop);
    }

  protected:
    std::vector<double> densities(const ProblemData& data, const std::vector<double>& mesh) override {
        std::vector<double> found = cell_densities(*data.monitor, mesh);
        look_at(data, mesh);
        return found;
    }
    double residual_unit(const ProblemData& data, double mass) const override {
        return normalised_ ? 1 / mass : data.unit;
    }

    /// A shot towards the solution of the discrete equations, to rounding.
    std::optional<Evaluation> finish(const ProblemData& data, State& state) override {
        if (!converges_) return std::nullopt;
        if (!shooting_) shooting_.emplace(x());
        if (shooting_->stuck()) return std::nullopt;
        shooting_->step(*data.monitor);
        mesh_of(state) = shooting_->mesh();
        Evaluation evaluation = look(data, mesh_of(state));
        evaluation.step_size = 1;
        evaluation.ending = Ending::not_yet;
        if (shooting_->converged(equal_shares)) {
            evaluation.ending = Ending::complete;
            if (shooting_->deviation() > equal_shares)
                evaluation.note = "the numbers are too coarse for more: shares of cells differ by up to " +
                                  exact_number(shooting_->deviation()) + ", as nodes are rounded";
        } else if (shooting_->stuck()) {
            evaluation.ending = Ending::by_criterion;
            evaluation.note =
                "the density has features between nodes, which this mesh cannot share out evenly; "
                "more cells may help";
        }
        return evaluation;
    }

  private:
    bool normalised_ = true, converges_ = true;
    std::optional<IntervalShooting> shooting_;
};

} // namespace

/// Rows of all domains; each uses those that it needs.
static std::vector<ParameterRow> mesh_pde_rows() {
    std::vector<ParameterRow> rows = MeshLevels::rows(4, 3, 0);
    rows.push_back(
        {.key = "finish",
         .label = "On the last mesh",
         .kind = ParameterKind::choice,
         .default_value = std::string("converged"),
         .choices = {"converged", "fixed-point"},
         .help = "converged: to the solution of the discrete equations, by shooting on an interval, by "
                 "Newton's method on a quadrilateral; fixed-point: final_solves solves as in the paper, "
                 "which need not converge"});
    rows.push_back(
        {.key = "normalised",
         .label = "Normalised residual",
         .kind = ParameterKind::boolean,
         .default_value = true,
         .help =
             "on an interval: the residual divided by the integral of ρ; off: as Hill and Madden print it"});
    for (ParameterRow& row : quadrilateral_rows()) rows.push_back(std::move(row));
    rows.push_back(reference_row());
    return rows;
}

MethodType mesh_pde_method() {
    return {
        .name = "mesh-pde",
        .label = "Mesh PDE",
        .help =
            "(ρ x')' = 0 or div(M grad x) = 0 by a fixed-point iteration, from coarse meshes to fine ones",
        .rows = mesh_pde_rows(),
        .residual = {.name = "residual",
                     .label = "Mesh PDE residual",
                     .symbol = "‖res‖",
                     .scale = ParameterScale::logarithmic,
                     .help =
                         "on an interval the L2 norm of the residual, on a quadrilateral the largest change "
                         "that the next solve makes"},
        .fields = layer_fields(),
        .colour = "solution",
        .make = [](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
            auto domain = discretisation_as<IntervalDomain>(context.discretisation);
            return std::make_unique<IntervalMeshPde>(std::move(domain), values);
        }};
}

} // namespace gaspard
