// The data of a problem apart from its domain, as methods get it; made and checked once per scenario.
//
//   mesh equidistribution   m(x) > 0, the monitor
//   optimal transport       m(x) on the target domain, source(xi) on the source domain
//   mesh PDE                a symmetric positive definite tensor M(x); then m = sqrt(det M)
//   a PDE on the mesh       its coefficients, as the values of the section "pde"
#pragma once

#include "core/base/export.hpp"
#include "core/monitor/tensor.hpp"

#include <memory>
#include <stop_token>
#include <string>

namespace gaspard GASPARD_API {

/// Immutable; copies share everything.
struct ProblemData {
    /// The density that the mesh equidistributes; never null. Diagnostics use it for every method.
    std::shared_ptr<const Monitor> monitor;
    /// The monitor's unit: results that have its dimension are multiplied by it (theta, masses), steps of the
    /// relaxation divided by it. A power of two; 1 unless squares of the caller's monitor would overflow.
    double unit = 1;
    std::shared_ptr<const TensorMonitor> tensor{}; ///< null: the problem has a scalar monitor
    std::shared_ptr<const Monitor> source{};       ///< density on the source domain; null: constant
    std::string pde_type{};                        ///< of PdeType; empty: the problem has no section pde
    std::shared_ptr<const Values> pde{};           ///< its values; null: the problem has no section pde
    std::shared_ptr<const MonitorReport> report{}; ///< of the scalar monitor; null: it says nothing
    std::stop_token stop{}; ///< Method::measures() that take long throw Interrupted when it is requested
};

/// Problem data of a scalar monitor. Throws InputError if the monitor is not positive (Monitor::check).
ProblemData scalar_problem(std::shared_ptr<const Monitor> monitor);
/// Problem data of a tensor monitor M, with m = sqrt(det M). Throws InputError if M is not positive definite
/// (TensorMonitor::check).
ProblemData tensor_problem(std::shared_ptr<const TensorMonitor> tensor);

} // namespace GASPARD_API
