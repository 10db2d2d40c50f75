#include "cli/commands.hpp"
#include "core/scenario/toml.hpp"
#include "gui/window.hpp"

#include <exception>
#include <iostream>

namespace gaspard {

namespace {

/// A window that closes has done its work, so trouble with the file is a remark, no failure.
void remember(const std::filesystem::path& file, const Settings& settings) {
    try {
        write_settings(file, settings);
    } catch (const std::exception& error) {
        std::cerr << "gaspard: the window's place and look are not remembered: " << error.what() << "\n";
    }
}

} // namespace

int window_command(std::shared_ptr<const Catalogue> catalogue, const std::string& name,
                   const std::vector<std::string>& settings, const std::optional<std::string>& size) {
    Scenario scenario = find_scenario(*catalogue, name);
    apply_settings(*catalogue, scenario, settings);
    check(*catalogue, scenario);
    const std::filesystem::path file = settings_file();
    WindowOptions options;
    options.settings = read_settings(file, options.complaints);
    if (size) {
        apply_size(scenario, *size);
        for (const char* key : {"width", "height"}) options.settings.window.set(key, scenario.view.at(key));
        options.settings.window.set("maximized", false);
    }
    if (name.ends_with(".toml")) remember_recent(options.settings, name);
    remember(file, run_window(std::move(catalogue), scenario, options));
    return 0;
}

} // namespace gaspard
