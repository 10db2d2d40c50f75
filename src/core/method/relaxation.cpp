// The relaxation method of McRae, Cotter, Budd, section 3.1:
//
//   <grad v, grad phi^{k+1}> = <grad v, grad phi^k> + dt <v, m det(I + sigma^k) - theta^k>       (3.7)
//
// sigma, x and theta follow from phi; see fem/plane_q2.hpp.
#include "core/base/check.hpp"
#include "core/fem/plane_q2.hpp"
#include "core/method/method.hpp"

namespace gaspard {

namespace {

class Relaxation final : public Method {
  public:
    Relaxation(std::shared_ptr<const PlaneQ2> plane, const Values& values)
        : plane_(std::move(plane)), room_(plane_->make_room()), monitor_(plane_->mesh()->node_count()),
          residual_(plane_->unknowns()), update_(plane_->unknowns()) {
        configure(values);
    }

    void configure(const Values& values) override { step_size_ = values.real("step_size"); }

    void use_threads(int threads) override { room_ = plane_->make_room(threads); }
    double other_cpu_seconds() const override { return room_.team->other_cpu_seconds(); }

    State initial_state() const override {
        return {layout(plane_->grid()), {{"phi", std::vector<double>(plane_->unknowns(), 0.0)}}};
    }

    std::optional<State> adopt(const State& other) override {
        if (other.arrays.size() != 1 || other.arrays[0].name != "phi") return std::nullopt;
        const auto& phi = other.arrays[0].values;
        if (other.layout == layout(plane_->grid()) && phi.size() == plane_->unknowns()) return other;
        for (LineGrid from{4, plane_->grid().periodic}; from.size(2) * from.size(2) <= phi.size();
             ++from.cells)
            if (other.layout == layout(from) && from.size(2) * from.size(2) == phi.size())
                return State{layout(plane_->grid()), {{"phi", plane_->transfer(from, phi, room_)}}};
        return std::nullopt;
    }

    Evaluation evaluate(const Monitor& monitor, const State& state, std::stop_token) override {
        const auto& phi = potential(state);
        plane_->positions(phi, positions_, room_);
        monitor.values(positions_, monitor_);
        plane_->hessian(phi, sigma_, room_);
        const auto [theta, normalised] = plane_->residual(monitor_, sigma_, residual_, room_);
        return {.residual = normalised, .theta = theta, .step_size = 0};
    }

    Evaluation step(const Monitor& monitor, State& state, std::stop_token stop) override {
        potential(state); // checks that it is of this layout before anything is written
        plane_->poisson(residual_, update_, room_);
        auto& phi = state.arrays[0].values;
        for (std::size_t i = 0; i < phi.size(); ++i) phi[i] += step_size_ * update_[i];
        Evaluation evaluation = evaluate(monitor, state, stop);
        evaluation.step_size = step_size_;
        return evaluation;
    }

    const Points& positions() const override { return positions_; }

  private:
    static std::string layout(const LineGrid& grid) {
        return std::string("plane ") + (grid.periodic ? "periodic" : "walls") +
               " Q2 n=" + std::to_string(grid.cells);
    }
    const std::vector<double>& potential(const State& state) const {
        GASPARD_CHECK(state.layout == layout(plane_->grid()) && state.arrays.size() == 1);
        GASPARD_CHECK(state.arrays[0].values.size() == plane_->unknowns());
        return state.arrays[0].values;
    }

    std::shared_ptr<const PlaneQ2> plane_;
    PlaneQ2::Room room_;
    double step_size_ = 0;
    // Of the state last evaluated:
    Points positions_;
    std::vector<double> monitor_; ///< m at the mesh's nodes
    WeakHessian sigma_;
    std::vector<double> residual_, update_;
};

} // namespace

MethodType relaxation_method() {
    return {
        .name = "relaxation",
        .label = "Relaxation",
        .help = "an explicit step of the parabolic equation: robust, linear convergence",
        .rows = {{.key = "step_size",
                  .label = "Step size",
                  .symbol = "dt",
                  .minimum = 1e-4,
                  .maximum = 10,
                  .scale = ParameterScale::logarithmic,
                  .default_value = 0.1,
                  .help =
                      "larger is faster until the iteration diverges; sharper monitors want smaller steps"}},
        .make = [](std::shared_ptr<const Discretisation> discretisation,
                   const Values& values) -> std::unique_ptr<Method> {
            auto plane = std::dynamic_pointer_cast<const PlaneQ2>(std::move(discretisation));
            GASPARD_CHECK(plane != nullptr);
            return std::make_unique<Relaxation>(std::move(plane), values);
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
