// The window's settings, which are kept between sessions: place, size, appearance, and recent files.
//
// A TOML file with the rows below as keys of [window], and the recent scenario files and folders. A
// missing file gives the defaults; invalid entries are ignored and reported, so that the window always opens.
#pragma once

#include "core/base/parameter.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace gaspard {

/// The table of all settings.
std::vector<ParameterRow> settings_rows();

struct Settings {
    Values window{"window", settings_rows()};
    std::vector<std::string> recent;  ///< absolute paths of scenario files, the newest first
    std::vector<std::string> folders; ///< that files were chosen in, the newest first

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Puts a file, or a folder, first among the recent ones; at most `recent_limit` are kept.
inline constexpr std::size_t recent_limit = 8;
void remember_recent(Settings& settings, const std::filesystem::path& file);
void remember_folder(Settings& settings, const std::filesystem::path& folder);
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
