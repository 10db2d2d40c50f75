#include "core/session/snapshot.hpp"

#include "core/base/check.hpp"

namespace gaspard {

std::string_view status_name(RunStatus status) {
    switch (status) {
    case RunStatus::preparing:
        return "preparing";
    case RunStatus::running:
        return "running";
    case RunStatus::converged:
        return "converged";
    case RunStatus::iteration_limit:
        return "iteration-limit";
    case RunStatus::stalled:
        return "stalled";
    case RunStatus::diverged:
        return "diverged";
    case RunStatus::tangled:
        return "tangled";
    case RunStatus::interrupted:
        return "interrupted";
    case RunStatus::failed:
        return "failed";
    }
    check_failed("the status has a name");
}

bool is_final(RunStatus status) { return status != RunStatus::preparing && status != RunStatus::running; }

} // namespace gaspard
