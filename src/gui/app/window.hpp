// The window on a screen: GLFW, an OpenGL 3.3 core context, input, and a loop that sleeps when nothing
// happens.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "gui/base/settings.hpp"

#include <filesystem>
#include <memory>

namespace gaspard {

struct WindowOptions {
    std::filesystem::path output = "gaspard-out"; ///< exports and pictures go into a folder per scenario here
    Settings settings;                   ///< what was remembered; the size is no more than the screen has
    std::vector<std::string> complaints; ///< what was wrong with it
};

/// Shows the scenario until the user closes the window; returns what is to be remembered. To be called on the
/// main thread. Throws MachineError where there is no display or no OpenGL 3.3.
Settings run_window(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                    const WindowOptions& options);

} // namespace gaspard
