// Scenarios as TOML files.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// Throws InputError with file and line: broken TOML, unknown key (with the nearest known one), value out of
/// range.
Scenario parse_scenario(const Catalogue& catalogue, std::string_view text, const std::string& origin);
Scenario load_scenario(const Catalogue& catalogue, const std::filesystem::path& file);
/// The complete scenario, every default filled in; reads back to the same scenario.
std::string to_toml(const Scenario& scenario);

struct BuiltinScenario {
    std::string_view name; ///< "plane-ring"
    std::string_view toml;
};
/// The shipped scenarios, embedded at build time.
std::vector<BuiltinScenario> builtin_scenarios();
/// A built-in name or the path of a .toml file. Throws InputError, with the nearest name.
Scenario find_scenario(const Catalogue& catalogue, const std::string& name_or_file);

} // namespace gaspard
