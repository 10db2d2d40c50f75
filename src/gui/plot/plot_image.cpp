#include "gui/plot/plot_image.hpp"

#include "gui/gl/offscreen.hpp"
#include "gui/plot/plot_widget.hpp"

#include <cmath>
#include <type_traits>

namespace gaspard {

namespace {

constexpr float image_width = 960, image_height = 600; // in units of scale 1

/// ImDrawData holds a vector of lists since 1.89.8, and pointed to an array of them before.
template <class Lists>
void show_only(Lists& lists, ImDrawList*& list) {
    if constexpr (std::is_pointer_v<Lists>)
        lists = &list;
    else
        lists.push_back(list);
}

ImDrawData draw_data(ImDrawList*& list, ImVec2 size, float density) {
    ImDrawData data;
    data.Valid = true;
    show_only(data.CmdLists, list);
    data.CmdListsCount = 1;
    data.TotalVtxCount = list->VtxBuffer.Size;
    data.TotalIdxCount = list->IdxBuffer.Size;
    data.DisplaySize = size;
    data.FramebufferScale = {density, density};
    return data;
}

} // namespace

Image draw_plot_image(const Gl& gl, ImGuiRenderer& renderer, const Plot& plot, const Theme& theme,
                      float scale, float density) {
    const ImVec2 size{image_width * scale, image_height * scale};
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRect({0, 0}, size);
    const float margin = 16 * scale;
    draw_plot(list, plot, {{margin, margin}, {size.x - margin, size.y - margin}}, theme, scale);
    const auto pixels = [density](float units) { return static_cast<int>(std::lround(units * density)); };
    const RenderTarget target(gl, pixels(size.x), pixels(size.y));
    target.bind();
    gl.Disable(GL_SCISSOR_TEST);
    gl.ClearColor(theme.background.r, theme.background.g, theme.background.b, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    ImDrawList* lists = &list;
    renderer.draw(draw_data(lists, size, density));
    Image image = target.read();
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
}

} // namespace gaspard
