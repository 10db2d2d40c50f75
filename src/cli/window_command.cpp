#include "cli/commands.hpp"
#include "core/base/error.hpp"
#include "core/scenario/toml.hpp"
#include "gui/viewport.hpp"
#include "gui/document.hpp"
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

/// What the scenario leaves open is as it was when the window was closed.
void look_as_before(const Catalogue& catalogue, Scenario& scenario, const Values& remembered) {
    if (is_default(scenario.view, "theme")) scenario.view.set("theme", remembered.at("theme"));
    if (!is_default(scenario.view, "camera") || remembered.text("camera_scenario") != scenario.name) return;
    try {
        set_value(catalogue, scenario, "view.camera", remembered.at("camera"));
        check_view(scenario.view);
    } catch (const InputError&) { // edited by hand: home will do
        scenario.view.set("camera", std::string());
    }
}

} // namespace

int window_command(std::shared_ptr<const Catalogue> catalogue, const std::string& name,
                   const std::vector<std::string>& settings, const std::optional<std::string>& size) {
    const std::filesystem::path file = settings_file();
    WindowOptions options;
    options.settings = read_settings(file, options.complaints);
    Scenario scenario = find_scenario(*catalogue, name);
    if (!name.ends_with(".toml")) scenario = for_window(*catalogue, std::move(scenario));
    look_as_before(*catalogue, scenario, options.settings.window);
    apply_settings(*catalogue, scenario, settings);
    check(*catalogue, scenario);
    check_view(scenario.view);
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
