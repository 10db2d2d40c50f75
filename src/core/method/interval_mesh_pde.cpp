// The mesh PDE (rho(x) x')' = 0 on an interval, by the iterations of Hill, Madden (2021): Algorithm 1 starts
// on the mesh of the run, Algorithm 2 on a coarse one, with some solves on every mesh before it is refined.
//
// An iteration is one solve of (15). On the last mesh they go on until the residual (16) is below
// method.tolerance, or as often as method.final_solves says; or shots solve the discrete equations to
// rounding (layer/interval_shooting.hpp), which the iteration does not for thin layers.
#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/layer/interval_shooting.hpp"
#include "core/method/interval_method.hpp"
#include "core/method/mesh_levels.hpp"
#include "core/method/quadrilateral_mesh_pde.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

constexpr double equal_shares = 1e-12; ///< relative difference of the shares of a mesh that has converged

class IntervalMeshPde final : public IntervalMethod {
  public:
    IntervalMeshPde(std::shared_ptr<const IntervalDomain> domain, const Values& values)
        : IntervalMethod(std::move(domain)) {
        configure(values);
    }

    void configure(const Values& values) override {
        levels_.configure(values, domain().cells(), false);
        normalised_ = values.boolean("normalised");
        converges_ = values.text("finish") == "converged";
        shooting_.reset();
    }

    std::vector<SeriesInfo> series() const override {
        std::vector<SeriesInfo> all = IntervalMethod::series();
        all.push_back(level_series());
        return all;
    }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token) override {
        levels_.begin();
        shooting_.reset();
        Evaluation evaluation = look(data, mesh_of(state));
        if (level() > 0) evaluation.ending = Ending::not_yet;
        return evaluation;
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token) override {
        const std::size_t level = levels_.next(this->level());
        if (level != this->level())
            look(data, level > this->level()
                           ? uniform_interval(domain().interval(), levels_.cells(level))
                           : resampled_interval(x(), static_cast<std::size_t>(levels_.cells(level))));
        const bool shoots = converges_ && level == 0;
        if (shoots && !shooting_) shooting_.emplace(x());
        if (shoots && !shooting_->stuck()) return shot(data, state);
        mesh_of(state) = next_interval_mesh(densities_, domain().interval());
        Evaluation evaluation = look(data, mesh_of(state));
        evaluation.step_size = 1;
        evaluation.ending = levels_.ending(level);
        return evaluation;
    }

  private:
    std::size_t level() const { return levels_.level_of(static_cast<int>(x().size()) - 1); }

    /// On the last mesh: towards the solution of the discrete equations, to rounding.
    Evaluation shot(const ProblemData& data, State& state) {
        shooting_->step(*data.monitor);
        mesh_of(state) = shooting_->mesh();
        Evaluation evaluation = look(data, mesh_of(state));
        evaluation.step_size = 1;
        evaluation.ending = Ending::not_yet;
        if (shooting_->converged(equal_shares)) {
            evaluation.ending = Ending::complete;
            if (shooting_->deviation() > equal_shares)
                evaluation.note = "the numbers are too coarse for more: shares of cells differ by up to " +
                                  format_number(shooting_->deviation()) + ", as nodes are rounded";
        } else if (shooting_->stuck()) {
            evaluation.ending = Ending::by_criterion;
            evaluation.note =
                "the density has features between nodes, which this mesh cannot share out evenly; "
                "more cells may help";
        }
        return evaluation;
    }

    Evaluation look(const ProblemData& data, const std::vector<double>& x) {
        densities_ = cell_densities(*data.monitor, x);
        look_at(data, x);
        double mass = 0;
        for (std::size_t i = 0; i < densities_.size(); ++i) mass += densities_[i] * (x[i + 1] - x[i]);
        const double unit = normalised_ ? 1 / mass : data.unit;
        return {.residual = unit * interval_residual(densities_, x),
                .series = {static_cast<double>(level())}};
    }

    MeshLevels levels_;
    bool normalised_ = true, converges_ = true;
    std::vector<double> densities_;
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
            if (auto plane = std::dynamic_pointer_cast<const QuadrilateralDomain>(context.discretisation))
                return quadrilateral_mesh_pde(std::move(plane), values);
            auto domain = std::dynamic_pointer_cast<const IntervalDomain>(context.discretisation);
            GASPARD_CHECK(domain != nullptr); // guaranteed by the capability table
            return std::make_unique<IntervalMeshPde>(std::move(domain), values);
        }};
}

} // namespace gaspard
