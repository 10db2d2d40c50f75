// The exit codes. Scripts depend on them.
#pragma once

#include "core/session/snapshot.hpp"

namespace gaspard {

constexpr int exit_fault = 1; ///< internal error or machine error
constexpr int exit_input = 2; ///< invalid usage or input

inline int exit_code(RunStatus status) {
    switch (status) {
    case RunStatus::converged:
        return 0;
    case RunStatus::iteration_limit:
        return 3;
    case RunStatus::diverged:
    case RunStatus::tangled:
        return 4;
    case RunStatus::stalled:
        return 5;
    case RunStatus::invalid_input:
        return exit_input;
    case RunStatus::interrupted:
        return 130;
    case RunStatus::preparing:
    case RunStatus::running:
    case RunStatus::failed:
        return exit_fault;
    }
    return exit_fault;
}

} // namespace gaspard
