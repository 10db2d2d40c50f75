#include "core/method/plane_equation.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace gaspard {

namespace {

std::string layout_of(const LineGrid& grid) {
    return std::string("plane ") + (grid.periodic ? "periodic" : "walls") +
           " Q2 n=" + std::to_string(grid.cells);
}

} // namespace

PlaneEquation::PlaneEquation(std::shared_ptr<const PlaneQ2> plane)
    : plane_(std::move(plane)), layout_(layout_of(plane_->grid())), room_(plane_->make_room()),
      monitor_(plane_->mesh()->node_count()), residual_(plane_->unknowns()) {}

State PlaneEquation::initial_state() const {
    return {layout_, {{"phi", std::vector<double>(plane_->unknowns(), 0.0)}}};
}

std::optional<State> PlaneEquation::adopt(const State& other) {
    if (other.arrays.size() != 1 || other.arrays[0].name != "phi") return std::nullopt;
    const auto& phi = other.arrays[0].values;
    if (other.layout == layout_ && phi.size() == plane_->unknowns()) return other;
    for (LineGrid from{4, plane_->grid().periodic}; from.size(2) * from.size(2) <= phi.size(); ++from.cells)
        if (other.layout == layout_of(from) && from.size(2) * from.size(2) == phi.size()) {
            PlaneEquation there(std::make_shared<PlaneQ2>(from));
            return adopt(there, phi);
        }
    return std::nullopt;
}

State PlaneEquation::adopt(PlaneEquation& other, std::span<const double> phi) {
    return {layout_, {{"phi", plane_->transfer(*other.plane_, phi, other.room_, room_)}}};
}

std::vector<double>& PlaneEquation::potential(State& state) const {
    GASPARD_CHECK(state.layout == layout_ && state.arrays.size() == 1);
    GASPARD_CHECK(state.arrays[0].values.size() == plane_->unknowns());
    return state.arrays[0].values;
}

const std::vector<double>& PlaneEquation::potential(const State& state) const {
    return potential(const_cast<State&>(state)); // which only looks
}

Evaluation PlaneEquation::evaluate(const Monitor& monitor, std::span<const double> phi) {
    plane_->positions(phi, positions_, room_);
    monitor.values(positions_, monitor_);
    plane_->hessian(phi, sigma_, room_);
    const auto [theta, normalised] = plane_->residual(monitor_, sigma_, residual_, room_);
    return {.residual = normalised, .theta = theta, .step_size = 0};
}

double stable_step(const Ellipticity& ellipticity) {
    constexpr double shortened = 0.98; // the extremes are those at the vertices
    return shortened * 2 / (ellipticity.fastest + std::max(0.0, ellipticity.slowest));
}

std::shared_ptr<const PlaneQ2> plane_of(std::shared_ptr<const Discretisation> discretisation) {
    auto plane = std::dynamic_pointer_cast<const PlaneQ2>(std::move(discretisation));
    GASPARD_CHECK(plane != nullptr);
    return plane;
}

} // namespace gaspard
