// Helper for capability rows: makes a nonlinear problem from the discretisation that `prepare` made.
#pragma once

#include "core/mesh/discretisation_as.hpp"
#include "core/method/nonlinear_problem.hpp"

#include <memory>
#include <utility>

namespace gaspard {

/// A value for Capability::problem. The discretisation must be of class Discretised (GASPARD_CHECK).
template <class Problem, class Discretised>
std::unique_ptr<NonlinearProblem> problem_on(std::shared_ptr<const Discretisation> discretisation) {
    return std::make_unique<Problem>(discretisation_as<Discretised>(std::move(discretisation)));
}

} // namespace gaspard
