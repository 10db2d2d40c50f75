#include "gui/base/settings.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/atomic_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <toml++/toml.h>

namespace gaspard {

namespace {

ParameterRow number(const char* key, ParameterKind kind, double low, double high, Value value,
                    const char* help) {
    return {.key = key,
            .label = key,
            .kind = kind,
            .minimum = low,
            .maximum = high,
            .default_value = std::move(value),
            .help = help};
}

ParameterRow flag(const char* key, bool value, const char* help) {
    return {.key = key, .label = key, .kind = ParameterKind::boolean, .default_value = value, .help = help};
}

ParameterRow text(const char* key, std::string value, const char* help) {
    return {.key = key,
            .label = key,
            .kind = ParameterKind::text,
            .default_value = std::move(value),
            .help = help};
}

void read_window(Values& window, const toml::table& table, const std::string& origin,
                 std::vector<std::string>& complaints) {
    for (const auto& [key, node] : table) {
        try {
            if (const auto* real = node.as_floating_point())
                window.set(key.str(), real->get());
            else if (const auto* whole = node.as_integer())
                window.set(key.str(), std::int64_t{whole->get()});
            else if (const auto* boolean = node.as_boolean())
                window.set(key.str(), boolean->get());
            else if (const auto* words = node.as_string())
                window.set(key.str(), words->get());
            else
                throw InputError("window." + std::string(key.str()) + " must be a single value");
        } catch (const InputError& error) {
            complaints.push_back(origin + ": " + error.what());
        }
    }
}

void read_paths(toml::node_view<const toml::node> list, std::vector<std::string>& paths) {
    if (const auto* entries = list.as_array())
        for (const auto& entry : *entries)
            if (const auto* path = entry.as_string(); path && paths.size() < recent_limit)
                paths.push_back(path->get());
}

toml::array path_list(const std::vector<std::string>& paths) {
    toml::array list;
    for (const std::string& path : paths) list.push_back(path);
    return list;
}

} // namespace

std::vector<ParameterRow> settings_rows() {
    constexpr auto whole = ParameterKind::integer;
    constexpr auto real = ParameterKind::real;
    return {number("width", whole, 320, 32768, std::int64_t{1400}, "of the window, in its own units"),
            number("height", whole, 240, 32768, std::int64_t{900}, "of the window, in its own units"),
            number("left", whole, -32768, 32768, std::int64_t{0}, "left edge of the window"),
            number("top", whole, -32768, 32768, std::int64_t{0}, "top edge of the window"),
            flag("placed", false, "whether left and top are known"),
            flag("maximized", false, "whether the window is maximized"),
            {.key = "theme",
             .label = "theme",
             .kind = ParameterKind::choice,
             .default_value = std::string("dark"),
             .choices = {"dark", "light"},
             .help = "the colours of the window"},
            number("text_size", real, 0.6, 3, 1.0, "1 is normal, 1.7 is for a projector"),
            flag("sidebar", true, "whether the sliders are shown"),
            flag("plots", true, "whether the plots are shown"),
            flag("earlier_solves", true, "whether the plots show the solves before the last change"),
            flag("log", false, "whether the messages are shown"),
            number("sidebar_width", real, 12, 60, 19.0, "in widths of the font"),
            number("plots_share", real, 0.15, 0.7, 0.26, "of the space beside the parameters"),
            text("first_plot", "residual,iterations,linear,log", "what the first plot shows"),
            text("second_plot", "equidistribution,iterations,linear,log", "what the second plot shows"),
            text("camera", "", "the last camera, as in view.camera"),
            text("camera_scenario", "", "the scenario of that camera")};
}

void remember_recent(Settings& settings, const std::filesystem::path& file) {
    forget_recent(settings, file);
    settings.recent.insert(settings.recent.begin(), std::filesystem::absolute(file).string());
    if (settings.recent.size() > recent_limit) settings.recent.resize(recent_limit);
}

void remember_folder(Settings& settings, const std::filesystem::path& folder) {
    const std::string path = std::filesystem::absolute(folder).lexically_normal().string();
    std::erase(settings.folders, path);
    settings.folders.insert(settings.folders.begin(), path);
    if (settings.folders.size() > recent_limit) settings.folders.resize(recent_limit);
}

void forget_recent(Settings& settings, const std::filesystem::path& file) {
    std::erase(settings.recent, std::filesystem::absolute(file).string());
}

double within(const Values& values, std::string_view key, double value) {
    for (const ParameterRow& row : values.rows())
        if (row.key == key) return std::clamp(value, row.minimum, row.maximum);
    return value;
}

std::filesystem::path settings_file() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::filesystem::path(value ? value : "");
    };
    const std::filesystem::path home = variable("HOME"), config = variable("XDG_CONFIG_HOME");
    if (config.is_absolute()) return config / "gaspard" / "window.toml";
    if (home.is_absolute()) return home / ".config" / "gaspard" / "window.toml";
    return {};
}

Settings read_settings(const std::filesystem::path& file, std::vector<std::string>& complaints) {
    Settings settings;
    std::error_code ignored;
    if (file.empty() || !std::filesystem::exists(file, ignored)) return settings;
    try {
        const toml::table document = toml::parse(read_file(file), file.string());
        if (const auto* window = document["window"].as_table())
            read_window(settings.window, *window, file.string(), complaints);
        read_paths(document["recent"], settings.recent);
        read_paths(document["folders"], settings.folders);
    } catch (const toml::parse_error& error) {
        complaints.push_back(file.string() + ": " + std::string(error.description()));
    } catch (const std::exception& error) {
        complaints.emplace_back(error.what());
    }
    return settings;
}

std::string settings_toml(const Settings& settings) {
    toml::table window;
    for (const ParameterRow& row : settings.window.rows())
        std::visit([&](const auto& value) { window.insert(row.key, value); }, settings.window.at(row.key));
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "# What Gaspard's window remembers; written whenever it closes.\n"
        << toml::table{{"recent", path_list(settings.recent)},
                       {"folders", path_list(settings.folders)},
                       {"window", window}}
        << "\n";
    return out.str();
}

void write_settings(const std::filesystem::path& file, const Settings& settings) {
    if (file.empty()) return;
    check_writable(file.parent_path());
    write_atomically(file, settings_toml(settings));
}

} // namespace gaspard
