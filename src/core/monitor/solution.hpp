// The function u whose interpolation error the mesh of a monitor is to reduce: Monitor::solution(), or the
// monitor itself.
#pragma once

#include "core/function/scalar_function.hpp"
#include "core/monitor/problem_data.hpp"

#include <memory>

namespace gaspard {

/// In the unit of the caller's monitor (ProblemData::unit). The monitor must have gradients, as that of a run
/// has.
std::shared_ptr<const ScalarFunction> solution_of(const ProblemData& data);

} // namespace gaspard
