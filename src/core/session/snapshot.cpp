#include "core/session/snapshot.hpp"

#include "core/base/check.hpp"

#include <cmath>
#include <limits>

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
    case RunStatus::invalid_input:
        return "invalid-input";
    case RunStatus::interrupted:
        return "interrupted";
    case RunStatus::failed:
        return "failed";
    }
    check_failed("the status has a name");
}

std::optional<double> StepReport::value(std::string_view name) const {
    const auto place = series->find(name);
    return place ? value(*place) : std::nullopt;
}

std::optional<double> StepReport::value(std::size_t place) const {
    if (place == SeriesTable::residual()) return residual;
    if (place == series->step_size()) return step_size > 0 ? std::optional(step_size) : std::nullopt;
    const std::size_t slot = series->slot(place);
    if (slot >= values.size() || std::isnan(values[slot])) return std::nullopt;
    return values[slot];
}

void StepReport::set(std::string_view name, double value) {
    const auto place = series->find(name);
    GASPARD_CHECK(place && *place != SeriesTable::residual() && *place != series->step_size());
    values.resize(series->slots(), std::numeric_limits<double>::quiet_NaN());
    values[series->slot(*place)] = value;
}

bool is_final(RunStatus status) { return status != RunStatus::preparing && status != RunStatus::running; }

} // namespace gaspard
