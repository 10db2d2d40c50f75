#include "core/method/equation.hpp"

#include "core/base/check.hpp"
#include "core/method/plane_equation.hpp"
#include "core/method/spline_equation.hpp"
#include "core/method/surface_equation.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

State Equation::state_of(std::vector<double> phi) const {
    GASPARD_CHECK(phi.size() == unknowns_);
    return {layout_, {{"phi", std::move(phi)}}};
}

std::vector<double>& Equation::potential(State& state) const {
    GASPARD_CHECK(state.layout == layout_ && state.arrays.size() == 1);
    GASPARD_CHECK(state.arrays[0].values.size() == unknowns_);
    return state.arrays[0].values;
}

const std::vector<double>& Equation::potential(const State& state) const {
    return potential(const_cast<State&>(state)); // which only looks
}

std::unique_ptr<Equation> make_equation(std::shared_ptr<const Discretisation> discretisation) {
    if (auto plane = std::dynamic_pointer_cast<const PlaneQ2>(discretisation))
        return std::make_unique<PlaneEquation>(std::move(plane));
    if (auto surface = std::dynamic_pointer_cast<const SurfaceQ2>(discretisation))
        return std::make_unique<SurfaceEquation>(std::move(surface));
    if (auto patch = std::dynamic_pointer_cast<const SplineDomain>(discretisation))
        return std::make_unique<SplineEquation>(std::move(patch));
    check_failed("the discretisation is of a domain with a Monge-Ampere equation");
}

double stable_step(const Ellipticity& ellipticity) {
    constexpr double shortened = 0.98; // the extremes are those at the vertices
    constexpr double careful = 0.1;    // where nothing is elliptic, and so nothing to go by
    if (!(ellipticity.fastest > 0)) return careful;
    return std::min(longest_step, shortened * 2 / (ellipticity.fastest + std::max(0.0, ellipticity.slowest)));
}

double preconditioner_scale(double monitor) { return 1 / std::pow(monitor, 0.2); }

} // namespace gaspard
