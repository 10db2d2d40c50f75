// What tells two scenarios apart, in words: "amplitude 20". Names of runs and marks in plots are made from
// it.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// One value that differs. Of a section of another type only the type is named.
struct ValueChange {
    std::string key;   ///< "monitor.amplitude", "monitor.type"
    std::string label; ///< "amplitude"
    std::string before, after;
};

/// In the order of the rows; domain, monitor and method only, for view and output change no solution.
std::vector<ValueChange> value_changes(const Scenario& before, const Scenario& after);

/// "amplitude 10 to 20, cells per side 60 to 120"
std::string describe_changes(const std::vector<ValueChange>& changes);

/// "Ring, amplitude 20": the monitor, and what is no longer as the scenario was opened.
std::string describe_scenario(const Catalogue& catalogue, const Scenario& opened, const Scenario& scenario);

/// Such texts without what stands in all of them, where there is little room: "amplitude 20" and "Ring" of
/// "Ring, amplitude 20, radius 0.3" and "Ring, radius 0.3".
std::vector<std::string> what_differs(const std::vector<std::string>& texts);

} // namespace gaspard
