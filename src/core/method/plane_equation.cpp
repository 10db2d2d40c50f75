#include "core/method/plane_equation.hpp"

#include "core/base/check.hpp"

namespace gaspard {

namespace {

constexpr std::size_t shortest_side = 24; // minimum number of cells per side of a coarser mesh

std::string layout_of(const LineGrid& grid) {
    return std::string("plane ") + (grid.periodic ? "periodic" : "walls") +
           " Q2 n=" + std::to_string(grid.cells);
}

} // namespace

PlaneEquation::PlaneEquation(std::shared_ptr<const PlaneQ2> plane)
    : MongeAmpereEquation(layout_of(plane->grid()), plane->unknowns()), plane_(std::move(plane)),
      workspace_(plane_->make_workspace()), monitor_(plane_->mesh()->node_count()),
      residual_(plane_->unknowns()) {}

std::optional<State> PlaneEquation::adopt(const State& other, const Discretisation*) {
    if (other.arrays.size() != 1 || other.arrays[0].name != "phi") return std::nullopt;
    const auto& phi = other.arrays[0].values;
    if (other.layout == layout() && phi.size() == plane_->unknowns()) return other;
    for (LineGrid from{4, plane_->grid().periodic}; from.size(2) * from.size(2) <= phi.size(); ++from.cells)
        if (other.layout == layout_of(from) && from.size(2) * from.size(2) == phi.size()) {
            PlaneEquation there(std::make_shared<PlaneQ2>(from));
            return adopt(there, phi);
        }
    return std::nullopt;
}

State PlaneEquation::adopt(NonlinearProblem& other, std::span<const double> phi) {
    auto& from = dynamic_cast<PlaneEquation&>(other);
    return state_of(plane_->transfer(*from.plane_, phi, from.workspace_, workspace_));
}

std::unique_ptr<NonlinearProblem> PlaneEquation::coarser(const Progress&, std::stop_token) const {
    const LineGrid half{(plane_->grid().cells + 1) / 2, plane_->grid().periodic};
    if (half.cells < shortest_side) return nullptr;
    return std::make_unique<PlaneEquation>(std::make_shared<PlaneQ2>(half));
}

Evaluation PlaneEquation::evaluate(const ProblemData& data, std::span<const double> phi) {
    plane_->positions(phi, positions_, workspace_);
    data.monitor->values(positions_, monitor_);
    plane_->hessian(phi, sigma_, workspace_);
    const auto [theta, normalised] = plane_->residual(monitor_, sigma_, residual_, workspace_);
    theta_ = theta;
    return {.residual = normalised, .series = {data.unit * theta}, .step_size = 0};
}

void PlaneEquation::linearise(const ProblemData& data, Linearised how) {
    d_monitor_.assign(monitor_.size(), 0.0);
    slope_.resize(0);
    if (how == Linearised::fully) data.monitor->gradients(positions_, slope_);

    // m at the unknowns: the nodal value at vertices, else the mean of the two or four nearest vertices.
    scale_.resize(size());
    scaled_.resize(size());
    const std::size_t line = plane_->size(), side = plane_->grid().cells + 1;
    for (std::size_t j = 0; j < line; ++j)
        for (std::size_t i = 0; i < line; ++i) {
            const double* below = &monitor_[j / 2 * side + i / 2];
            const double* above = below + j % 2 * side;
            const double m = (below[0] + below[i % 2] + above[0] + above[i % 2]) / 4;
            scale_[j * line + i] = preconditioner_scale(m);
        }
}

void PlaneEquation::derivative(std::span<const double> w, std::span<double> out) {
    if (slope_.size() > 0) {
        plane_->displacement(w, displacement_, workspace_);
        for (std::size_t i = 0; i < d_monitor_.size(); ++i)
            d_monitor_[i] = slope_.x[i] * displacement_.x[i] + slope_.y[i] * displacement_.y[i];
    }
    plane_->hessian(w, d_sigma_, workspace_);
    plane_->residual_derivative(monitor_, sigma_, d_monitor_, d_sigma_, out, workspace_);
    for (double& value : out) value = -value;
}

void PlaneEquation::precondition(std::span<const double> r, std::span<double> u) {
    for (std::size_t i = 0; i < u.size(); ++i) scaled_[i] = scale_[i] * r[i];
    plane_->poisson(scaled_, u, workspace_);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] *= scale_[i];
}

} // namespace gaspard
