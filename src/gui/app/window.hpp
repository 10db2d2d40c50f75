// The window on a screen: GLFW, an OpenGL 3.3 core context, input, and a loop that sleeps when nothing
// happens.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "gui/base/output_folders.hpp"
#include "gui/base/settings.hpp"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

struct WindowOptions {
    OutputFolders output{"gaspard-out"}; ///< as in ApplicationOptions
    std::optional<Scenario> named{};     ///< see Document::open
    std::stop_token stop{};              ///< closes the window, as the user does
    Settings settings;                   ///< of the last time; the size is limited to the screen
    std::vector<std::string> complaints; ///< about invalid settings
};

/// Shows the scenario until the user closes the window; returns the settings to be saved. Call it on the main
/// thread. Throws MachineError if there is no display or no OpenGL 3.3.
Settings run_window(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                    const WindowOptions& options);

} // namespace gaspard
