// The mesh PDE (rho(x) x')' = 0 on an interval, by the iterations of Hill, Madden (2021): Algorithm 1 starts on
// the mesh of the run, Algorithm 2 on a coarse one, with some solves on every mesh before it is refined.
//
// An iteration is one solve of (15). On the last mesh they go on until the residual (16) is below
// method.tolerance, or as often as method.final_solves says.
#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/method/interval_method.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gaspard {

namespace {

class IntervalMeshPde final : public IntervalMethod {
  public:
    IntervalMeshPde(std::shared_ptr<const IntervalDomain> domain, const Values& values)
        : IntervalMethod(std::move(domain)) {
        configure(values);
    }

    void configure(const Values& values) override {
        const auto start = static_cast<int>(values.integer("start_cells"));
        if (start > domain().cells())
            throw InputError("method.start_cells (" + std::to_string(start) +
                             ") must not be greater than domain.cells (" + std::to_string(domain().cells()) +
                             ")");
        inner_ = static_cast<int>(values.integer("inner_solves"));
        final_ = static_cast<int>(values.integer("final_solves"));
        normalised_ = values.boolean("normalised");
        levels_ = {domain().cells()};
        while (values.boolean("refine") && levels_.back() > 1 && (levels_.back() + 1) / 2 >= start)
            levels_.push_back((levels_.back() + 1) / 2);
    }

    std::vector<SeriesInfo> series() const override {
        std::vector<SeriesInfo> all = IntervalMethod::series();
        all.push_back(level_series());
        return all;
    }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token) override {
        fresh_ = true;
        solves_ = 0;
        Evaluation evaluation = look(data, mesh_of(state));
        if (level() > 0) evaluation.ending = Ending::not_yet;
        return evaluation;
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token) override {
        std::vector<double>& x = mesh_of(state);
        const bool restart = std::exchange(fresh_, false) && level() == 0;
        if (restart && levels_.size() > 1) {
            look(data, uniform_interval(domain().interval(), levels_.back()));
            solves_ = 0;
        } else if (level() > 0 && solves_ >= inner_) {
            look(data, resampled_interval(this->x(), static_cast<std::size_t>(levels_[level() - 1])));
            solves_ = 0;
        }
        x = next_interval_mesh(densities_, domain().interval());
        ++solves_;
        const std::size_t of_update = level();
        Evaluation evaluation = look(data, x);
        evaluation.step_size = 1;
        evaluation.series = {static_cast<double>(of_update)};
        if (of_update > 0)
            evaluation.ending = Ending::not_yet;
        else if (final_ > 0)
            evaluation.ending = solves_ >= final_ ? Ending::complete : Ending::not_yet;
        return evaluation;
    }

  private:
    /// The level of the mesh last looked at: 0 is that of the run.
    std::size_t level() const {
        const auto cells = static_cast<int>(x().size()) - 1;
        const auto found = std::find(levels_.begin(), levels_.end(), cells);
        return found == levels_.end() ? 0 : static_cast<std::size_t>(found - levels_.begin());
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

    int inner_ = 3, final_ = 0;
    bool normalised_ = true;
    std::vector<int> levels_; ///< cells, from the mesh of the run to the coarsest
    std::vector<double> densities_;
    int solves_ = 0; ///< on the present level
    bool fresh_ = false;
};

} // namespace

MethodType mesh_pde_method() {
    return {.name = "mesh-pde",
            .label = "Mesh PDE",
            .help = "(ρ(x) x')' = 0 by a fixed-point iteration, from coarse meshes to fine ones",
            .rows = {{.key = "refine",
                      .label = "Start coarse",
                      .kind = ParameterKind::boolean,
                      .default_value = true,
                      .help = "starts on a coarse mesh, which is refined (Algorithm 2); off: Algorithm 1"},
                     {.key = "start_cells",
                      .label = "Coarsest mesh",
                      .kind = ParameterKind::integer,
                      .minimum = 1,
                      .maximum = 65536,
                      .scale = ParameterScale::logarithmic,
                      .slider = SliderRange{1, 64},
                      .default_value = std::int64_t{4},
                      .help = "the coarsest mesh has at least as many cells"},
                     {.key = "inner_solves",
                      .label = "Solves per mesh",
                      .kind = ParameterKind::integer,
                      .minimum = 1,
                      .maximum = 1000,
                      .slider = SliderRange{1, 20},
                      .default_value = std::int64_t{3},
                      .help = "solves on each coarser mesh"},
                     {.key = "final_solves",
                      .label = "Final solves",
                      .kind = ParameterKind::integer,
                      .minimum = 0,
                      .maximum = 10000,
                      .slider = SliderRange{0, 20},
                      .default_value = std::int64_t{0},
                      .help = "solves on the last mesh; 0: until the residual is below the tolerance"},
                     {.key = "normalised",
                      .label = "Normalised residual",
                      .kind = ParameterKind::boolean,
                      .default_value = true,
                      .help = "the residual divided by the integral of ρ; off: as Hill and Madden print it"}},
            .residual = {.name = "residual",
                         .label = "Mesh PDE residual",
                         .symbol = "‖res‖",
                         .scale = ParameterScale::logarithmic,
                         .help = "L2 norm of the residual of the mesh PDE"},
            .fields = interval_fields(),
            .colour = "solution",
            .make = [](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
                auto domain = std::dynamic_pointer_cast<const IntervalDomain>(context.discretisation);
                GASPARD_CHECK(domain != nullptr); // guaranteed by the capability table
                return std::make_unique<IntervalMeshPde>(std::move(domain), values);
            }};
}

} // namespace gaspard
