// A plot of the window as an image: what a file shows is what render_plot() draws.
#include "gui/app/viewport_image.hpp"
#include "gui/gl/imgui_context.hpp"
#include "gui/plot/plot_image.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

Plot falling_plot() {
    Plot plot{.title = "Residual", .x = {"iteration"}, .y = {"", true}, .curves = {}};
    Curve curve{.label = "Ring", .x = {}, .y = {}, .colour = 1};
    for (int i = 0; i <= 100; ++i) curve.x.push_back(i), curve.y.push_back(std::pow(10, -0.08 * i));
    plot.curves = {curve, {.label = "none", .x = {}, .y = {}}};
    return plot;
}

Image draw(const Plot& plot, const Theme& theme, float scale, float density) {
    const auto context = make_offscreen_context();
    const ImGuiSession session;
    ImGui::GetIO().DisplaySize = {300, 200}; // the window may be smaller than the image
    load_font(*ImGui::GetIO().Fonts, theme, scale * density);
    ImGui::GetIO().FontGlobalScale = 1 / density;
    ImGuiRenderer renderer(context->gl());
    ImGui::NewFrame();
    ImGui::Render();
    Image image = draw_plot_image(context->gl(), renderer, plot, theme, scale, density);
    EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return image;
}

/// How many pixels have about this colour.
int pixels_of_colour(const Image& image, Colour colour) {
    const auto near = [](std::uint8_t value, float wanted) {
        return std::abs(static_cast<float>(value) - 255 * wanted) < 12;
    };
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        count += near(image.rgba[i], colour.r) && near(image.rgba[i + 1], colour.g) &&
                 near(image.rgba[i + 2], colour.b);
    return count;
}

TEST(PlotPicture, ShowsTheCurvesInTheirColoursAtAnyDensity) {
    for (const Theme& theme : {dark_theme(), light_theme()})
        for (const float density : {1.0F, 2.0F}) {
            const Image image = draw(falling_plot(), theme, 1, density);
            EXPECT_EQ(image.width, static_cast<int>(960 * density));
            EXPECT_EQ(image.height, static_cast<int>(600 * density));
            const int curve = pixels_of_colour(image, theme.curves[1]);
            EXPECT_GT(curve, 700 * density) << "as long as the picture is wide";
            EXPECT_LT(curve, 6000 * density * density) << "a line, not an area";
            EXPECT_GT(pixels_of_colour(image, theme.background), 20000);
        }
}

TEST(PlotPicture, ShowsNoMoreThanWasAskedFor) {
    Plot plot = falling_plot();
    plot.x.low = 200, plot.x.high = 300; // beyond the curve's end
    const Theme theme = light_theme();
    EXPECT_LT(pixels_of_colour(draw(plot, theme, 1, 1), theme.curves[1]), 100) << "in the legend only";
}

} // namespace
} // namespace gaspard
