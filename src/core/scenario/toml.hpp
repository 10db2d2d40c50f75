// Scenarios as TOML files.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// Throws InputError with file and line if the TOML is invalid, a key is unknown (the message names the
/// nearest known key) or a value is out of range. `origin` is the file name in messages.
Scenario parse_scenario(const Catalogue& catalogue, std::string_view text, const std::string& origin);
/// Reads and parses a file. Throws InputError.
Scenario load_scenario(const Catalogue& catalogue, const std::filesystem::path& file);
/// The complete scenario including default values; parse_scenario returns the same scenario.
std::string to_toml(const Scenario& scenario);

struct BuiltinScenario {
    std::string_view name; ///< "plane-ring"
    std::string_view toml;
};
/// The built-in scenarios, embedded at build time, in natural order.
std::vector<BuiltinScenario> builtin_scenarios();
/// Loads a built-in scenario by name, or a .toml file by its path. Throws InputError; for an unknown name the
/// message names the nearest.
Scenario find_scenario(const Catalogue& catalogue, const std::string& name_or_file);

} // namespace gaspard
