// A scenario: what to solve, as plain data. Every value is there, checked against its row. `gaspard list`
// shows all keys with their ranges; a scenario is made by default_scenario() or find_scenario(), and changed
// by set_value().
#pragma once

#include "core/base/parameter.hpp"

#include <string>

namespace gaspard {

/// A section whose rows depend on its type: domain, monitor, method.
struct Section {
    std::string type;
    Values values;
    friend bool operator==(const Section&, const Section&) = default;
};

struct Scenario {
    std::string name;        ///< "plane-ring"; of a file: its name without the ending
    std::string title;       ///< for people
    std::string description; ///< one line
    Section domain, monitor, method;
    Values view, output;
    friend bool operator==(const Scenario&, const Scenario&) = default;
};

} // namespace gaspard
