// The window on a screen: GLFW, an OpenGL 3.3 core context, input, and a loop that sleeps when nothing
// happens.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <filesystem>
#include <memory>

namespace gaspard {

struct WindowOptions {
    int width = 1400, height = 900; ///< of a display of scale 1; no more than the screen has
    std::filesystem::path output =
        "gaspard-out"; ///< exports and screenshots go into a folder per scenario here
};

/// Shows the scenario until the user closes the window; returns the program's exit code. To be called on the
/// main thread. Throws MachineError where there is no display or no OpenGL 3.3.
int run_window(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
               const WindowOptions& options);

} // namespace gaspard
