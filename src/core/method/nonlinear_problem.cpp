#include "core/method/nonlinear_problem.hpp"

#include "core/base/check.hpp"

namespace gaspard {

State NonlinearProblem::state_of(std::vector<double> unknowns) const {
    GASPARD_CHECK(unknowns.size() == size_);
    return {layout_, {{array_, std::move(unknowns)}}};
}

std::vector<double>& NonlinearProblem::unknowns(State& state) const {
    GASPARD_CHECK(state.layout == layout_ && state.arrays.size() == 1);
    GASPARD_CHECK(state.arrays[0].values.size() == size_);
    return state.arrays[0].values;
}

const std::vector<double>& NonlinearProblem::unknowns(const State& state) const {
    return unknowns(const_cast<State&>(state)); // which is not modified
}

} // namespace gaspard
