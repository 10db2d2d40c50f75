// The complete window, on a screen or in memory: the meshes that an application asks for, then everything
// else.
#pragma once

#include "core/io/image.hpp"
#include "gui/application.hpp"
#include "gui/imgui_renderer.hpp"
#include "gui/mesh_renderer.hpp"
#include "gui/offscreen.hpp"

#include <memory>

namespace gaspard {

/// Of a framebuffer: its size in pixels, and how many of them a unit of the window has.
struct WindowPixels {
    int width = 0, height = 0;
    float density = 1;
};

/// Where a part of the window lies in the framebuffer.
PixelRect pixels_of(const ItemRectangle& part, float density);

/// Draws the frame that ImGui has just rendered, and the meshes below it, into the bound framebuffer. `zoom`:
/// units of the window per unit of the theme.
void draw_window(const Gl& gl, const Application& application, MeshRenderers& meshes,
                 ImGuiRenderer& interface, const WindowPixels& pixels, float zoom);

/// The window as it would show a run that has ended, drawn offscreen. Throws MachineError where there is no
/// OpenGL.
Image render_whole_window(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& run, int width,
                          int height, const Settings& settings = {},
                          OffscreenBackend backend = OffscreenBackend::any);

} // namespace gaspard
