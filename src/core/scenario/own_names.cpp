#include "core/scenario/own_names.hpp"

namespace gaspard {

Scenario with_own_names(Scenario scenario) {
    constexpr const char* ending = " (modified)"; // once is enough, as in the title
    scenario.title = scenario_title(scenario);
    std::string& text = scenario.description;
    if (!scenario.modified.empty() && !text.empty() && !text.ends_with(ending)) text += ending;
    scenario.modified.clear();
    return scenario;
}

} // namespace gaspard
