// Scenarios as TOML files.
#pragma once

#include "core/base/export.hpp"
#include "core/scenario/catalogue.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

/// Where the keys of a scenario are in its file, for messages about values that are checked later.
struct ScenarioSource {
    std::string name;                           ///< of the file
    std::map<std::string, std::uint32_t> lines; ///< "view.camera": 12
};
/// The message with file and line in front if it names a key that the file has; otherwise unchanged.
std::string with_place(const ScenarioSource& source, const std::string& message);

/// Throws InputError with file and line if the TOML is invalid, a key is unknown (the message names the
/// nearest known key) or a value is out of range. `origin` is the file name in messages, `folder` the base of
/// relative paths (Scenario::folder).
Scenario parse_scenario(const Catalogue& catalogue, std::string_view text, const std::string& origin,
                        ScenarioSource* source = nullptr, const std::filesystem::path& folder = {});
/// The largest scenario file that is read: 4 MiB.
inline constexpr std::uintmax_t largest_scenario_file = std::uintmax_t{1} << 22;
/// Reads and parses a file. Throws InputError.
Scenario load_scenario(const Catalogue& catalogue, const std::filesystem::path& file,
                       ScenarioSource* source = nullptr);
/// Whether a text is the path of a scenario file, .toml in any case, and not a name.
bool is_scenario_file(std::string_view name_or_file);
/// The complete scenario including default values; parse_scenario returns the same scenario. Throws
/// InputError if a text is not UTF-8.
std::string to_toml(const Scenario& scenario);

struct BuiltinScenario {
    std::string_view name; ///< "plane-ring"
    std::string_view toml;
};
/// The built-in scenarios, embedded at build time, in natural order.
std::vector<BuiltinScenario> builtin_scenarios();
/// Loads a built-in scenario by name, a .toml file by its path, or one from standard input ("-"). Throws
/// InputError; for an unknown name the message names the nearest.
Scenario find_scenario(const Catalogue& catalogue, const std::string& name_or_file,
                       ScenarioSource* source = nullptr);

} // namespace GASPARD_API
