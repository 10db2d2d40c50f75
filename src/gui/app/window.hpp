// The window on a screen: GLFW, an OpenGL 3.3 core context, input, and a loop that sleeps when nothing
// happens.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "gui/base/settings.hpp"

#include <filesystem>
#include <memory>

namespace gaspard {

struct WindowOptions {
    std::filesystem::path output = "gaspard-out"; ///< files are written to `output`/<scenario>
    Settings settings;                            ///< of the last time; the size is limited to the screen
    std::vector<std::string> complaints;          ///< about invalid settings
};

/// Shows the scenario until the user closes the window; returns the settings to be saved. Call it on the main
/// thread. Throws MachineError if there is no display or no OpenGL 3.3.
Settings run_window(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                    const WindowOptions& options);

} // namespace gaspard
