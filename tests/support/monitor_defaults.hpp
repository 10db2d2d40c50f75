// Built-in monitors by name, and their defaults.
#pragma once

#include "core/base/growing_values.hpp"
#include "core/monitor/monitor.hpp"

#include <stdexcept>

namespace gaspard {

inline MonitorType monitor_type(const std::string& name) {
    for (const MonitorType& type : monitor_types())
        if (type.name == name) return type;
    throw std::invalid_argument("no monitor " + name);
}

/// The values of all its rows, with their defaults.
inline Values default_values(const MonitorType& type, const Space& space) {
    const auto further = [&](const Values& values) {
        return type.further_rows ? type.further_rows(values, space) : std::vector<ParameterRow>();
    };
    return grown_values("monitor", type.rows(space), further, [](Values&) {});
}

} // namespace gaspard
