#include "cli/commands.hpp"
#include "core/scenario/toml.hpp"
#include "gui/window.hpp"

namespace gaspard {

int window_command(std::shared_ptr<const Catalogue> catalogue, const std::string& name,
                   const std::vector<std::string>& settings, const std::optional<std::string>& size) {
    Scenario scenario = find_scenario(*catalogue, name);
    apply_settings(*catalogue, scenario, settings);
    check(*catalogue, scenario);
    WindowOptions options;
    if (size) {
        apply_size(scenario, *size);
        options.width = static_cast<int>(scenario.view.integer("width"));
        options.height = static_cast<int>(scenario.view.integer("height"));
    }
    return run_window(std::move(catalogue), scenario, options);
}

} // namespace gaspard
