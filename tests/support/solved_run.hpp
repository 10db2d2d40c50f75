// A built-in scenario with settings, solved.
#pragma once

#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <string>
#include <vector>

namespace gaspard {

inline gaspard::Run solved_run(const std::string& name, const std::vector<std::string>& settings) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, name);
    apply_settings(*catalogue, scenario, settings);
    gaspard::Run run(catalogue, scenario);
    run.solve();
    return run;
}

} // namespace gaspard
