// Differences between scenarios as text, such as "Amplitude A = 20": for names of runs and of earlier solves,
// and labels of edits.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// One value that differs. If the type of a section differs, only the type is listed.
struct ValueChange {
    std::string key;   ///< "monitor.amplitude", "monitor.type"
    std::string label; ///< "amplitude"
    std::string before, after;
    std::string name_before{}, name_after{}; ///< "Amplitude A = 20"; empty for types
};

/// In the order of the rows; domain, monitor and method only, as view and output do not affect the solution.
std::vector<ValueChange> value_changes(const Scenario& before, const Scenario& after);
/// The same and the changes of the output section.
std::vector<ValueChange> scenario_changes(const Scenario& before, const Scenario& after);
/// Changes of one section without a type, such as view.
std::vector<ValueChange> section_changes(const std::string& section, const Values& before,
                                         const Values& after);

/// What has changed, without the values: "amplitude, cells per side", "monitor type"; "5 values" if there are
/// more than three.
std::string name_changes(const std::vector<ValueChange>& changes);

/// Changes with their values as they are after them, or before: "Amplitude A = 20", "Boundary: walls",
/// "Newton".
std::vector<std::string> names_after(const Catalogue& catalogue, const std::vector<ValueChange>& changes);
std::vector<std::string> names_before(const Catalogue& catalogue, const std::vector<ValueChange>& changes);

/// "Ring, Amplitude A = 20", "Image photo.jpg": the monitor, and the values that differ from the scenario as
/// it was opened.
std::string describe_scenario(const Catalogue& catalogue, const Scenario& opened, const Scenario& scenario);

/// Shortens such texts by the parts that all of them share: "Ring, Amplitude A = 20, Radius r = 0.3"
/// and "Ring, Radius r = 0.3" become "Amplitude A = 20" and "Ring".
std::vector<std::string> what_differs(const std::vector<std::string>& texts);

} // namespace gaspard
