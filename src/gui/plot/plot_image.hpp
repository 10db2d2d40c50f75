// A plot of the window as an image for a file, drawn with the window's own OpenGL context and font.
//
// Not on another thread: ImGui's context is a global of the process, which drawing text needs. It takes
// some milliseconds; writing the file is slow, and is done on another thread.
#pragma once

#include "core/io/image.hpp"
#include "core/tessellate/plot.hpp"
#include "gui/base/theme.hpp"
#include "gui/gl/imgui_renderer.hpp"

namespace gaspard {

/// `scale`: how much larger than the theme says everything is in the window; `density`: pixels per unit of
/// the window. To be called between ImGui::Render() and ImGui::NewFrame(). Leaves the window's framebuffer
/// bound. Throws MachineError where the machine cannot draw an image of that size.
Image draw_plot_image(const Gl& gl, ImGuiRenderer& renderer, const Plot& plot, const Theme& theme,
                      float scale, float density);

} // namespace gaspard
