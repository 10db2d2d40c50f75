// Built-in monitors by name, as a scenario selects them.
#pragma once

#include "core/monitor/problem_data.hpp"
#include "support/monitor_defaults.hpp"

#include <utility>

namespace gaspard {

using Settings = std::vector<std::pair<std::string, double>>;

inline std::shared_ptr<const Monitor> make_monitor(const std::string& name, Space space,
                                                   const Settings& settings = {}) {
    const MonitorType type = monitor_type(name);
    Values values = default_values(type, space);
    for (const auto& [key, value] : settings)
        for (const auto& row : values.rows())
            if (row.key == key && row.kind == ParameterKind::integer)
                values.set(key, static_cast<std::int64_t>(value));
            else if (row.key == key)
                values.set(key, value);
    return type.make(values, {space});
}

/// The problem of a monitor that the caller keeps alive.
inline ProblemData problem_of(const Monitor& monitor) {
    return {.monitor = std::shared_ptr<const Monitor>(std::shared_ptr<const Monitor>(), &monitor)};
}

} // namespace gaspard
