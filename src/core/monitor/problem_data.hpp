// The data of a problem, beside its domain: what a method gets of a scenario, made and checked once.
//
//   mesh equidistribution   m(x) > 0, the monitor
//   optimal transport       m(x) on the source domain, target(y) on the target domain
//   mesh PDE                a symmetric positive definite tensor M(x); then m = sqrt(det M)
//   a PDE on the mesh       its coefficients, as the values of the section "pde"
#pragma once

#include "core/monitor/tensor.hpp"

#include <memory>

namespace gaspard {

/// Immutable; copies share everything.
struct ProblemData {
    /// The density that the mesh equidistributes; never null. Diagnostics measure with it, whatever the method.
    std::shared_ptr<const Monitor> monitor;
    std::shared_ptr<const TensorMonitor> tensor{}; ///< null: the problem is one of the scalar monitor
    std::shared_ptr<const Monitor> target{};       ///< density on the target domain; null: constant
    std::shared_ptr<const Values> pde{};           ///< null: no PDE is solved on the mesh
};

/// Of a scalar monitor. Throws InputError if the monitor is not positive (Monitor::check).
ProblemData scalar_problem(std::shared_ptr<const Monitor> monitor);
/// Of a tensor, with m = sqrt(det M) as monitor. Throws InputError if it is not positive definite
/// (TensorMonitor::check).
ProblemData tensor_problem(std::shared_ptr<const TensorMonitor> tensor);

} // namespace gaspard
