// Images compared with stored ones, and wrong images that must be found different.
#include "core/base/error.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/colouring.hpp"
#include "gui/app/strips.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/base/theme.hpp"
#include "gui/scenes.hpp"
#include "gui/similarity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

Image golden(const std::string& name) {
    return read_image(std::filesystem::path(GASPARD_SOURCE_DIR) / "tests/goldens" / (name + ".png"));
}

Image ring(const Snapshot& snapshot, const char* colour = "monitor", double blend = 1) {
    Values view("view", view_rows());
    view.set("color", std::string(colour));
    view.set("blend", blend);
    return render_view(snapshot, view, 400, 300, "plane, ring");
}

/// Without axes, whose numbers depend on where the mesh is.
Image mesh_alone(const Snapshot& snapshot, const char* colour = "monitor", double blend = 1) {
    Values view("view", view_rows());
    view.set("color", std::string(colour));
    view.set("blend", blend);
    view.set("axes", false);
    return render_view(snapshot, view, 400, 300, "plane, ring");
}

class Golden : public testing::TestWithParam<Scene> {};

TEST_P(Golden, LooksAsStored) {
    // read_image throws where the image is missing, which fails the test.
    EXPECT_EQ(difference(GetParam().draw(OffscreenBackend::any), golden(GetParam().name)), "");
}

TEST_P(Golden, LooksTheSameThroughEgl) {
    EXPECT_EQ(difference(GetParam().draw(OffscreenBackend::egl), golden(GetParam().name)), "");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(scenes()), [](const auto& parameter) {
    std::string name = parameter.param.name;
    std::erase(name, '-');
    return name;
});

TEST(WrongPicture, IsFoundDifferent) {
    const Image right = golden("ring-16");
    EXPECT_NE(difference(golden("ring-60"), right), "") << "another mesh";
    EXPECT_NE(difference(golden("ring-computational"), right), "") << "nodes not moved";
    EXPECT_NE(difference(golden("ring-plain"), right), "") << "no colours";
    EXPECT_NE(difference(golden("tangled"), right), "") << "one tangled cell";
    EXPECT_NE(difference(Image{400, 300, std::vector<std::uint8_t>(400 * 300 * 4, 0)}, right), "") << "black";
}

TEST(WrongPicture, OfAnIntervalIsFoundDifferent) {
    Snapshot snapshot = layer_snapshot(32, 0.01);
    const Values view("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    const auto drawn = [&] { return render_view(snapshot, view, 600, 450, "interval, layer"); };
    const Image right = golden("layers");
    EXPECT_EQ(difference(drawn(), right), "");
    snapshot.fields[0].values[16] -= 0.3;
    EXPECT_NE(difference(drawn(), right), "") << "the solution is wrong at one node";
    snapshot = layer_snapshot(32, 0.01);
    snapshot.x = snapshot.mesh->nodes;
    EXPECT_NE(difference(drawn(), right), "") << "nodes not moved";
}

/// What a view with other settings shows of the same mesh.
Image drawn(const Snapshot& snapshot, const std::vector<std::pair<std::string, std::string>>& settings) {
    Values values("view", view_rows());
    for (const auto& [key, text] : settings) values.parse(key, text);
    return render_view(snapshot, values, 400, 300, "plane, ring");
}

std::array<int, 4> pixel(const Image& image, int x, int y) {
    const auto* p = &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
    return {p[0], p[1], p[2], p[3]};
}

TEST(Picture, OfRunsHasTheOthersBesideTheFirst) {
    const Snapshot snapshot = ring_snapshot(16);
    Values view("view", view_rows());
    view.set("layout", std::string("runs"));
    view.set("axes", false);
    const Image alone = render_view(snapshot, view, 400, 300, "first");
    const Image both = render_view(snapshot, view, 400, 300, "first", {.beside = {{"second", &snapshot}}});
    const auto coloured = [](const Image& image, int from, int to) {
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = from; x < to; ++x) {
                const auto* pixel = &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
                if (std::abs(pixel[0] - pixel[1]) > 30) ++count;
            }
        return count;
    };
    const int left = coloured(both, 0, 170), right = coloured(both, 170, 340);
    EXPECT_GT(left, 3000);
    EXPECT_GT(right, left / 2) << "the same mesh again";
    EXPECT_LT(left, coloured(alone, 0, 340) / 2);
}

TEST(Strips, AnImageDrawnInStripsIsTheSame) {
    const Snapshot snapshot = ring_snapshot(16);
    Values values("view", view_rows());
    for (const char* background : {"theme", "transparent"}) {
        values.set("background", std::string(background));
        const Image whole = render_view(snapshot, values, 400, 300, "plane, ring");
        for (const int rows : {300, 150, 70, 1}) {
            const Image strips =
                render_view(snapshot, values, 400, 300, "plane, ring", {.most_pixels = 400 * rows + 399});
            ASSERT_EQ(strips.rgba.size(), whole.rgba.size());
            int different = 0; // by more than rounding
            for (std::size_t i = 0; i < whole.rgba.size(); ++i)
                different += std::abs(strips.rgba[i] - whole.rgba[i]) > 16 ? 1 : 0;
            EXPECT_LT(different, rows == 300 ? 1 : 400)
                << "of " << whole.rgba.size() << " in strips of " << rows;
        }
    }
}

TEST(Strips, AreWholeImagesUpToAFewMillionPixels) {
    EXPECT_EQ(strip_height(2048, 2048), 2048);
    EXPECT_EQ(strip_height(8192, 8192), 512);
    EXPECT_EQ(strip_height(64, 8192), 8192);
    EXPECT_EQ(strip_height(8192, 64), 64);
    EXPECT_EQ(strip_height(100, 50, 10), 1) << "a row at least";
    const Camera camera{{1, 2, 0}, 0.5, {1, 0, 0}, {0, 1, 0}};
    const PixelRect area{10, 20, 200, 100};
    EXPECT_FALSE(in_strip(camera, area, {120, 50}));
    EXPECT_FALSE(in_strip(camera, area, {0, 20}));
    EXPECT_EQ(in_strip(camera, area, {0, 200})->camera, camera);
    const auto part = in_strip(camera, area, {50, 40});
    ASSERT_TRUE(part);
    EXPECT_EQ(part->area.y, 0);
    EXPECT_EQ(part->area.height, 40);
    // Pixel (7, 33) of the view is pixel (7, 3) of its part.
    const Vec3 here = to_world(camera, area.size(), {7, 33}),
               there = to_world(part->camera, {200, 40}, {7, 3});
    EXPECT_LT(norm(here - there), 1e-12);
}

TEST(Background, IsTransparentOrAColour) {
    const Snapshot snapshot = ring_snapshot(16);
    const Image usual = drawn(snapshot, {});
    const Image clear = drawn(snapshot, {{"background", "transparent"}});
    const Image filled = drawn(snapshot, {{"background", "#fff1d6"}});
    EXPECT_EQ(drawn(snapshot, {{"background", "theme"}}).rgba, usual.rgba);
    EXPECT_EQ(pixel(clear, 1, 1)[3], 0);
    EXPECT_EQ(pixel(filled, 1, 1), (std::array{0xff, 0xf1, 0xd6, 255}));
    for (std::size_t i = 3; i < usual.rgba.size(); i += 4) {
        ASSERT_EQ(usual.rgba[i], 255);
        ASSERT_EQ(filled.rgba[i], 255);
    }
    // Laid over the theme's background, the transparent image is the usual one (but for plates below text).
    const Colour ground = dark_theme().background;
    const std::array below = {ground.r, ground.g, ground.b};
    int opaque_pixels = 0, far_off = 0;
    for (int y = 60; y < 240; ++y)
        for (int x = 100; x < 260; ++x) {
            const auto seen = pixel(clear, x, y), wanted = pixel(usual, x, y);
            const float alpha = static_cast<float>(seen[3]) / 255;
            opaque_pixels += seen[3] == 255 ? 1 : 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const float laid = alpha * static_cast<float>(seen[k]) + (1 - alpha) * 255 * below[k];
                far_off += std::abs(laid - static_cast<float>(wanted[k])) > 3 ? 1 : 0;
            }
        }
    EXPECT_GT(opaque_pixels, 20000) << "of the mesh";
    EXPECT_EQ(far_off, 0);
}

/// The image of an empty plot with a title.
Image titled(const std::string& title) {
    return render_plot({.title = title, .x = {"x", false}, .y = {"y", false}, .curves = {}}, 300, 200);
}

TEST(Title, EveryCharacterHasItsGlyph) {
    const Image unknown = titled("?");
    for (const char* title : {"Ω", "Ж", "é", "網"}) EXPECT_NE(titled(title).rgba, unknown.rgba) << title;
    // A character that no font has is shown as the font's sign for that: the comparison can fail.
    EXPECT_EQ(titled("\U0000FFFE").rgba, unknown.rgba);
}

TEST(WrongPicture, OfAnyOtherViewIsFoundDifferent) {
    const Snapshot snapshot = ring_snapshot(16);
    const Image right = drawn(snapshot, {});
    const std::pair<std::string, std::string> settings[] = {
        {"color", "area"},          {"color", "jacobian"},
        {"color", "displacement"},  {"color", "none"},
        {"color_map", "plasma"},    {"color_map", "ember"},
        {"color_map", "grey"},      {"color_map", "blue-yellow"},
        {"color_map", "blue-red"},  {"log", "true"},
        {"range", "fixed"},         {"histogram", "false"},
        {"lines", "false"},         {"arrows", "true"},
        {"contours", "8"},          {"elevation", "1"},
        {"blend", "0.5"},           {"layout", "computational"},
        {"layout", "side-by-side"}, {"pick", "cell 200"},
        {"theme", "light"},         {"camera", "centre 0.5 0.5 height 1"}};
    std::vector<Image> views = {right};
    for (const auto& [key, text] : settings) {
        views.push_back(drawn(snapshot, {{key, text}}));
        for (std::size_t i = 0; i + 1 < views.size(); ++i)
            EXPECT_NE(difference(views.back(), views[i]), "") << key << "=" << text << " and picture " << i;
    }
    EXPECT_EQ(difference(drawn(snapshot, {{"color_map", "viridis"}}), right), "")
        << "which is the automatic one";
    EXPECT_EQ(difference(drawn(snapshot, {{"direction", "left"}}), right), "") << "a plane has one side";
}

TEST(WrongPicture, OfAnotherDirectionIsFoundDifferent) {
    const Snapshot snapshot = cube_snapshot(4);
    std::vector<Image> views;
    for (const char* direction : {"home", "front", "left", "top"}) {
        views.push_back(drawn(snapshot, {{"direction", direction}}));
        for (std::size_t i = 0; i + 1 < views.size(); ++i)
            EXPECT_NE(difference(views.back(), views[i]), "") << direction;
    }
}

TEST(WrongPicture, OfAnotherMonitorIsFoundDifferent) {
    Snapshot snapshot = ring_snapshot(16);
    for (std::size_t i = 0; i < snapshot.x.size(); ++i)
        snapshot.fields[0].values[i] = 1 + 10 * std::exp(-20 * dot(snapshot.x[i], snapshot.x[i]));
    EXPECT_NE(difference(ring(snapshot), golden("ring-16")), "");
}

TEST(WrongPicture, OfAMirroredMeshIsFoundDifferent) {
    Snapshot snapshot = ring_snapshot(16);
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) // not symmetric, so that a mirror shows
        snapshot.x.x[i] += 0.05 * snapshot.x.y[i] * (1 - snapshot.x.y[i]);
    const Image right = ring(snapshot);
    for (double& x : snapshot.x.x) x = 1 - x;
    EXPECT_NE(difference(ring(snapshot), right), "");
}

TEST(WrongPicture, WithoutLinesIsFoundDifferent) {
    // The same surface from one cell: no lines inside.
    Snapshot lines = ring_snapshot(16), none = ring_snapshot(1);
    lines.x = lines.mesh->nodes;
    none.x = none.mesh->nodes;
    EXPECT_NE(difference(ring(lines, "none"), ring(none, "none")), "");
}

TEST(WrongPicture, WithALaterIterationInItsCaptionIsFoundDifferent) {
    Snapshot snapshot = ring_snapshot(16);
    snapshot.report.status = RunStatus::diverged;
    EXPECT_NE(difference(ring(snapshot), golden("ring-16")), "");
}

TEST(Picture, BlendGoesFromComputationalToPhysical) {
    const Snapshot snapshot = ring_snapshot(16);
    Snapshot unmoved = snapshot, half = snapshot;
    unmoved.x = snapshot.mesh->nodes;
    for (std::size_t i = 0; i < half.x.size(); ++i)
        half.x.set(i, 0.5 * (snapshot.mesh->nodes[i] + snapshot.x[i]));
    EXPECT_EQ(difference(mesh_alone(snapshot, "none", 0), mesh_alone(unmoved, "none")), "");
    EXPECT_EQ(difference(ring(snapshot, "none", 0.5), ring(half, "none")), "");
    EXPECT_NE(difference(ring(snapshot, "none", 0.5), ring(snapshot, "none")), "");
}

TEST(Picture, SameInputGivesTheSameBytes) {
    const Snapshot snapshot = ring_snapshot(30);
    EXPECT_EQ(ring(snapshot).rgba, ring(snapshot).rgba);
}

TEST(Picture, IsOpaqueAndOfTheSizeAskedFor) {
    Values view("view", view_rows());
    for (const auto& [width, height] : {std::pair{64, 64}, {65, 131}, {1000, 300}}) {
        const Image image = render_view(ring_snapshot(8), view, width, height);
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        ASSERT_EQ(image.rgba.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
    }
}

TEST(Picture, TangledCellsShowInEveryMapAndThemeEvenWhereCellsAreTiny) {
    const auto magenta = [](const Image& image) {
        int found = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            found += image.rgba[i] > 220 && image.rgba[i + 1] < 80 && image.rgba[i + 2] > 180;
        return found;
    };
    for (const int n : {16, 120})
        for (const char* theme : {"dark", "light"})
            for (const ColourMap& map : colour_maps()) {
                const std::vector<std::pair<std::string, std::string>> settings = {
                    {"theme", theme}, {"color_map", std::string(map.name)}};
                const Image with = drawn(tangled_snapshot(n), settings),
                            without = drawn(ring_snapshot(n), settings);
                EXPECT_GE(magenta(with) - magenta(without), 9)
                    << "n = " << n << ", " << theme << ", " << map.name;
                // Where it is, one also sees rings of both the text's and the background's colour.
                int dark = 0, light = 0;
                for (std::size_t i = 0; i < with.rgba.size() - 4 * 400 * 40; i += 4) { // above the caption
                    if (std::equal(&with.rgba[i], &with.rgba[i] + 3, &without.rgba[i])) continue;
                    const int sum = with.rgba[i] + with.rgba[i + 1] + with.rgba[i + 2];
                    dark += sum<150, light += sum> 600;
                }
                EXPECT_GE(dark, 8) << "n = " << n << ", " << theme << ", " << map.name;
                EXPECT_GE(light, 8) << "n = " << n << ", " << theme << ", " << map.name;
            }
}

TEST(Picture, LegendAndMeshHaveTheSameColours) {
    // Cells of one colour each: the middle of a cell has the colour of its value, whatever the scale.
    const Snapshot snapshot = ring_snapshot(8);
    for (const char* log : {"false", "true"}) {
        const Image image =
            drawn(snapshot, {{"color", "area"}, {"log", log}, {"camera", "centre 0.5 0.5 height 1"}});
        const auto colouring =
            make_colouring(snapshot, {.colouring = "area", .logarithmic = std::string(log) == "true"});
        ASSERT_TRUE(colouring);
        const auto corners = snapshot.mesh->cell(27);
        Vec3 middle;
        for (const auto node : corners) middle = middle + 0.25 * snapshot.x[static_cast<std::size_t>(node)];
        const int x = static_cast<int>(200 + (middle.x - 0.5) * 300),
                  y = static_cast<int>(150 - (middle.y - 0.5) * 300);
        const auto expected = colouring->colour(27);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(image.rgba[static_cast<std::size_t>(y * 400 + x) * 4 + c], expected[c], 3) << log;
    }
}

/// Mean brightness around a pixel, in linear light, with smooth weights.
double blurred(const Image& image, int left, int top) {
    constexpr int side = 24;
    double sum = 0, weights = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto window = [](int i) { return 1 - std::cos(2 * 3.14159265358979 * (i + 0.5) / side); };
            const auto at = static_cast<std::size_t>((top + y) * image.width + left + x) * 4;
            const double weight = window(x) * window(y);
            sum += weight * std::pow(image.rgba[at] / 255.0, 2.2);
            weights += weight;
        }
    return 255 * std::pow(sum / weights, 1 / 2.2);
}

TEST(Picture, DenseLinesDoNotBeatWithThePixels) {
    // A uniform mesh looks the same all over, from a coarse mesh to lines that merge.
    for (const int n : {110, 150, 190, 240, 480}) {
        Snapshot snapshot = ring_snapshot(n);
        snapshot.x = snapshot.mesh->nodes;
        for (const char* theme : {"dark", "light"}) {
            const Image image = drawn(
                snapshot, {{"color", "none"}, {"theme", theme}, {"camera", "centre 0.5 0.5 height 0.53"}});
            double low = 255, high = 0;
            for (int top = 20; top < 220; top += 5)
                for (int left = 60; left < 320; left += 5) {
                    const double here = blurred(image, left, top);
                    low = std::min(low, here), high = std::max(high, here);
                }
            EXPECT_LT(high - low, 6) << "n = " << n << ", " << theme;
        }
    }
}

TEST(Picture, ManyPointsDoNotDisturbWhatIsDrawnAfterThem) {
    // More corners of triangles than 16 bits can number; the second curve and the legend come after them.
    Plot plot;
    plot.curves = {{"many", {}, {}, false}, {"few", {0, 40000}, {0.5, 0.5}, false}};
    for (int i = 0; i < 40000; ++i) {
        plot.curves[0].x.push_back(i);
        plot.curves[0].y.push_back(i % 2);
    }
    const Image image = render_plot(plot, 400, 300);
    const Colour orange = dark_theme().curves[1];
    int found = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        found += std::abs(static_cast<float>(image.rgba[i]) - 255 * orange.r) < 12 &&
                 std::abs(static_cast<float>(image.rgba[i + 1]) - 255 * orange.g) < 12 &&
                 std::abs(static_cast<float>(image.rgba[i + 2]) - 255 * orange.b) < 12;
    EXPECT_GT(found, 300) << "a line across the plot, and one in the legend";
    EXPECT_LT(found, 1500);
}

TEST(Picture, NodesThatAreNotFiniteLeaveTheRestToBeSeen) {
    Snapshot snapshot = ring_snapshot(16);
    snapshot.x.x[40] = std::nan("");
    const Similarity s = compare(ring(snapshot), golden("ring-16"));
    EXPECT_GT(s.mean_structure, 0.95);
}

TEST(Picture, FarFromTheOriginLooksTheSame) {
    Snapshot snapshot = ring_snapshot(16);
    Mesh mesh = *snapshot.mesh;
    for (auto* x : {&mesh.nodes.x, &mesh.nodes.y, &snapshot.x.x, &snapshot.x.y})
        for (double& value : *x) value += 1e8;
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    EXPECT_EQ(difference(mesh_alone(snapshot), mesh_alone(ring_snapshot(16))), "");
}

TEST(Picture, HugeAndTinyMeshesLookTheSame) {
    for (const double factor : {1e8, 1e-8}) {
        Snapshot snapshot = ring_snapshot(16);
        Mesh mesh = *snapshot.mesh;
        for (auto* x : {&mesh.nodes.x, &mesh.nodes.y, &snapshot.x.x, &snapshot.x.y})
            for (double& value : *x) value *= factor;
        snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
        EXPECT_EQ(difference(mesh_alone(snapshot), mesh_alone(ring_snapshot(16))), "") << factor;
    }
}

/// The first columns of an image, from `left` on, that are not of its background.
int coloured_columns(const Image& image, int left, int right) {
    const auto coloured = [&](int x) {
        for (int y = image.height / 4; y < 3 * image.height / 4; ++y)
            if (pixel(image, x, y) == pixel(image, left, 0)) return false;
        return true;
    };
    while (left < right && !coloured(left)) ++left;
    int end = left;
    while (end < right && coloured(end)) ++end;
    return end - left;
}

TEST(Panels, ShowMeshesInOneSizeWhateverTheirLegends) {
    auto snapshot = std::make_shared<Snapshot>(ring_snapshot(16));
    std::vector<double> values(snapshot->mesh->cell_count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
    snapshot->fields.push_back({{.name = "number", .label = "a word", .place = FieldPlace::cell}, values});
    snapshot->fields.push_back(
        {{.name = "other", .label = "a label with many words", .place = FieldPlace::cell}, values});
    const MeshPanel narrow{"a", snapshot, "number", 0}, wide{"b", snapshot, "other", 0};
    const Image image = render_panels({narrow, wide}, 2, 800, 400);
    const int first = coloured_columns(image, 0, 400);
    EXPECT_GT(first, 100);
    EXPECT_EQ(first, coloured_columns(image, 400, 800));
}

TEST(Panels, AreNotDrawnOnceAskedToStop) {
    const auto snapshot = std::make_shared<Snapshot>(ring_snapshot(16));
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(render_panels({MeshPanel{"a", snapshot}}, 1, 100, 100, {.stop = source.get_token()}),
                 Interrupted);
    EXPECT_THROW(render_view(*snapshot, view("monitor", 1), 100, 100, "", {.stop = source.get_token()}),
                 Interrupted);
}

} // namespace
} // namespace gaspard
