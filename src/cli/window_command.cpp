#include "cli/commands.hpp"
#include "cli/interrupt_watch.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/tessellate/check_view.hpp"
#include "gui/app/window.hpp"
#include "gui/document/document.hpp"

#include <exception>
#include <iostream>

namespace gaspard {

namespace {

/// Saves the settings when the window closes. A failure is only reported.
void save_settings(const std::filesystem::path& file, const Settings& settings) {
    try {
        write_settings(file, settings);
    } catch (const std::exception& error) {
        std::cerr << "gaspard: cannot save the window settings: " << error.what() << "\n";
    }
}

/// Restores theme and camera of the last session unless the scenario sets them.
void restore_view(const Catalogue& catalogue, Scenario& scenario, const Values& remembered) {
    if (is_default(scenario.view, "theme")) scenario.view.set("theme", remembered.at("theme"));
    if (!is_default(scenario.view, "camera") || remembered.text("camera_scenario") != scenario.name) return;
    try {
        set_value(catalogue, scenario, "view.camera", remembered.at("camera"));
        check_view(scenario.view);
    } catch (const InputError&) { // invalid, probably edited by hand
        scenario.view.set("camera", std::string());
    }
}

/// Whether a setting names a value of the scenario's own method that the window's default method lacks.
bool needs_own_method(const std::vector<std::string>& settings, const Scenario& own, const Scenario& other) {
    bool asked = false;
    for (const std::string& setting : settings) {
        if (setting.starts_with("method.type=")) return false; // the method is given explicitly
        if (!setting.starts_with("method.")) continue;
        const std::string key = setting.substr(7, setting.find('=') - 7);
        asked = asked || (own.method.values.has(key) && !other.method.values.has(key));
    }
    return asked;
}

} // namespace

int window_command(std::shared_ptr<const Catalogue> catalogue, const std::string& name,
                   const std::vector<std::string>& settings, const std::optional<std::string>& size) {
    const std::filesystem::path file = settings_file();
    WindowOptions options;
    options.output.fallback = home_output();
    options.settings = read_settings(file, options.complaints);
    const bool from_file = is_scenario_file(name);
    ScenarioInput input = load_input(*catalogue, name, {});
    Scenario& scenario = input.scenario;
    if (!from_file && name != "-") {
        Scenario chosen = for_window(*catalogue, scenario);
        if (!needs_own_method(settings, scenario, chosen)) scenario = std::move(chosen);
    }
    restore_view(*catalogue, scenario, options.settings.window);
    input.named = scenario;
    options.named = scenario;
    change_input(*catalogue, input, settings);
    check_input(*catalogue, input);
    if (size) {
        apply_settings(*catalogue, scenario, size_settings(*size));
        for (const char* key : {"width", "height"}) options.settings.window.set(key, scenario.view.at(key));
        options.settings.window.set("maximized", false);
    }
    // Once the input is read: a signal ends a program that waits for it. Before the threads of graphics
    // start, which take over what it blocks.
    const InterruptWatch interrupt;
    options.stop = interrupt.token();
    if (from_file) remember_recent(options.settings, user_path(name));
    save_settings(file, run_window(std::move(catalogue), scenario, options));
    return 0;
}

} // namespace gaspard
