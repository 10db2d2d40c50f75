// The renderer of ImGui's triangles, compared pixel by pixel.
#include "gui/gl/imgui_context.hpp"
#include "gui/gl/imgui_renderer.hpp"
#include "gui/gl/offscreen.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr ImU32 red = IM_COL32(255, 0, 0, 255);

/// A red rectangle, cut by a smaller one, in a window of 100 x 80 units.
Image clipped_rectangle(ImVec2 low, ImVec2 high, float density) {
    const auto context = make_offscreen_context();
    const Gl& gl = context->gl();
    const RenderTarget target(gl, static_cast<int>(100 * density), static_cast<int>(80 * density), 0);
    const ImGuiSession session;
    ImGui::GetIO().DisplaySize = {100, 80};
    ImGui::GetIO().DisplayFramebufferScale = {density, density};
    ImGuiRenderer renderer(gl);
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect(low, high);
    list.AddRectFilled({0, 0}, {100, 80}, red);
    list.PopClipRect();
    ImGui::Render();
    target.bind();
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    renderer.draw(*ImGui::GetDrawData());
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return target.read();
}

TEST(ImGuiRenderer, CutsAtTheClipRectangle) {
    for (const float density : {1.0F, 2.0F}) {
        const Image image = clipped_rectangle({10, 20}, {60, 35}, density);
        const int d = static_cast<int>(density);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const bool inside = x >= 10 * d && x < 60 * d && y >= 20 * d && y < 35 * d;
                const auto at = static_cast<std::size_t>(y * image.width + x) * 4;
                ASSERT_EQ(image.rgba[at], inside ? 255 : 0) << x << ", " << y << " at " << density;
            }
    }
}

TEST(ImGuiRenderer, DrawsNothingWhereTheClipRectangleIsEmpty) {
    const Image image = clipped_rectangle({50, 20}, {50, 60}, 1);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 0);
}

TEST(ImGuiRenderer, DrawsPicturesOfSheetsAlsoThoseAddedLater) {
    const auto context = make_offscreen_context(OffscreenBackend::any);
    const ImGuiSession session;
    ImGui::GetIO().DisplaySize = {64, 32};
    ImGuiRenderer renderer(context->gl());
    RenderTarget target(context->gl(), 64, 32);
    auto sheet = std::make_shared<PictureSheet>(4, 4, 2);
    const auto plain = [](std::uint8_t red, std::uint8_t green) {
        Image image{4, 4, {}};
        for (int i = 0; i < 16; ++i)
            for (const int part : {int{red}, int{green}, 0, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(part));
        return image;
    };
    std::vector<PicturePlace> places = {sheet->add(plain(200, 0))};
    const auto draw = [&] {
        target.bind();
        context->gl().ClearColor(0, 0, 0, 1);
        context->gl().Clear(GL_COLOR_BUFFER_BIT);
        ImGui::NewFrame();
        float x = 0;
        for (const PicturePlace& place : places) {
            ImGui::GetForegroundDrawList()->AddImage(place.texture(), {x, 0}, {x + 32, 32}, place.low,
                                                     place.high);
            x += 32;
        }
        ImGui::Render();
        renderer.draw(*ImGui::GetDrawData());
        return target.read();
    };
    const auto at = [](const Image& image, int x) { return image.rgba.data() + 4 * (16 * image.width + x); };
    EXPECT_EQ(at(draw(), 16)[0], 200);
    places.push_back(sheet->add(plain(0, 150)));
    const Image both = draw();
    EXPECT_EQ(at(both, 16)[0], 200);
    EXPECT_EQ(at(both, 48)[1], 150);
    // Another sheet, perhaps at the same address.
    sheet = std::make_shared<PictureSheet>(4, 4, 2);
    places = {sheet->add(plain(90, 90))};
    EXPECT_EQ(at(draw(), 16)[0], 90);
}

} // namespace
} // namespace gaspard
