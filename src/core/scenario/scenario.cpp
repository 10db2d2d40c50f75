#include "core/scenario/scenario.hpp"

#include <string_view>

namespace gaspard {

namespace {

void add_modified(const Section& named, const Section& now, std::vector<std::string>& keys) {
    const std::string& section = (now.type.empty() ? named : now).values.section();
    if (named.type != now.type) {
        keys.push_back(section + ".type");
        return;
    }
    for (const ParameterRow& row : now.values.rows())
        if (!named.values.has(row.key) || named.values.at(row.key) != now.values.at(row.key))
            keys.push_back(section + "." + row.key);
}

/// Once is enough, also for a scenario that was saved and modified again.
std::string with_ending(std::string text, std::string_view ending, bool modified) {
    if (modified && !text.ends_with(ending)) text += ending;
    return text;
}

} // namespace

std::vector<std::string> modified_keys(const Scenario& named, const Scenario& scenario) {
    std::vector<std::string> keys;
    add_modified(named.domain, scenario.domain, keys);
    add_modified(named.monitor, scenario.monitor, keys);
    add_modified(named.target, scenario.target, keys);
    add_modified(named.method, scenario.method, keys);
    add_modified(named.pde, scenario.pde, keys);
    return keys;
}

std::string scenario_title(const Scenario& scenario) {
    return with_ending(scenario.title.empty() ? scenario.name : scenario.title, " (modified)",
                       !scenario.modified.empty());
}

std::string scenario_stem(const Scenario& scenario) {
    return with_ending(scenario.name, "-modified", !scenario.modified.empty());
}

} // namespace gaspard
