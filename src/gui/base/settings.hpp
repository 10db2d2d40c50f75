// What the window remembers from one time to the next: its place and size, how it looks, what was open.
//
// A TOML file: the rows below as keys of [window], and the scenario files opened last. A file that is missing
// gives the defaults; what is wrong in it is left out and said, for a window must open all the same.
#pragma once

#include "core/base/parameter.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace gaspard {

/// The one table of what is remembered.
std::vector<ParameterRow> settings_rows();

struct Settings {
    Values window{"window", settings_rows()};
    std::vector<std::string> recent; ///< absolute paths of scenario files, the newest first

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Puts a file first among the recent ones; at most `recent_limit` are kept.
inline constexpr std::size_t recent_limit = 8;
void remember_recent(Settings& settings, const std::filesystem::path& file);
void forget_recent(Settings& settings, const std::filesystem::path& file);

/// The nearest value that the row allows.
double within(const Values& values, std::string_view key, double value);

/// $XDG_CONFIG_HOME/gaspard/window.toml, or ~/.config/gaspard/window.toml; empty where neither is known.
std::filesystem::path settings_file();
/// `complaints` receives a sentence for each thing that was wrong.
Settings read_settings(const std::filesystem::path& file, std::vector<std::string>& complaints);
std::string settings_toml(const Settings& settings);
/// Throws InputError or MachineError where it cannot be written.
void write_settings(const std::filesystem::path& file, const Settings& settings);

} // namespace gaspard
