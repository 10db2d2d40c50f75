// Images of globes: shading, hidden surfaces, and negative controls.
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/colour_map.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/base/theme.hpp"
#include "gui/globes.hpp"
#include "gui/similarity.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

Image stored(const std::string& name) {
    return read_image(std::filesystem::path(GASPARD_SOURCE_DIR) / "tests/goldens" / (name + ".png"));
}

Image globe_image(const Snapshot& snapshot, const Settings& settings, int width = 400, int height = 300) {
    Values values("view", view_rows());
    for (const auto& [key, text] : settings) values.parse(key, text);
    return render_view(snapshot, values, width, height, "plane, ring");
}

std::array<int, 3> colour_at(const Image& image, int x, int y) {
    const auto at = static_cast<std::size_t>(y * image.width + x) * 4;
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

int apart(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// The unit ball around the origin fills nine tenths of the image's height.
const std::string look = "centre 0 0 0 height 2.2 right 0 1 0 up 0 0 1"; // from +x

TEST(WrongGlobe, IsFoundDifferent) {
    const Snapshot right = xn_globe(cubed_globe(8, 2), 2);
    EXPECT_EQ(difference(globe_image(right, {}), stored("globe-x2")), "");
    EXPECT_NE(difference(globe_image(xn_globe(cubed_globe(8, 2), 3), {}), stored("globe-x2")), "")
        << "another ratio";
    EXPECT_NE(difference(globe_image(xn_globe(cubed_globe(8, 1), 2), {}), stored("globe-x2")), "")
        << "straight";
    Snapshot unmoved = right;
    unmoved.x = unmoved.mesh->nodes;
    EXPECT_NE(difference(globe_image(unmoved, {}), stored("globe-x2")), "");
    const Settings others[] = {{{"layout", "projection"}},
                               {{"layout", "front-and-rear"}},
                               {{"direction", "back"}},
                               {{"layout", "projection"}, {"projection_longitude", "90"}},
                               {{"lines", "false"}}};
    std::vector<Image> views{globe_image(right, {})};
    for (const Settings& settings : others) {
        views.push_back(globe_image(right, settings));
        for (std::size_t i = 0; i + 1 < views.size(); ++i)
            EXPECT_NE(difference(views.back(), views[i]), "") << settings.back().second << ", " << i;
    }
    EXPECT_EQ(difference(globe_image(right, {{"spin", "30"}}), stored("globe-x2")), "")
        << "a file shows the start";
    EXPECT_EQ(difference(globe_image(right, {{"overlay", "exact"}}), stored("globe-x2")), "")
        << "none is known";
    const Snapshot beside = beside_exact_globe(6);
    EXPECT_NE(difference(globe_image(beside, {{"direction", "right"}}), stored("globe-exact")), "");
}

TEST(Globe, KeepsTheLegendsColoursWhereItFacesTheViewer) {
    for (const char* theme : {"dark", "light"})
        for (const int order : {1, 2}) {
            Snapshot snapshot = xn_globe(cubed_globe(16, order), 1.01);
            for (std::size_t i = 0; i < snapshot.x.size(); ++i)
                snapshot.fields[0].values[i] = snapshot.x[i].z;
            const Image image = globe_image(
                snapshot, {{"camera", look}, {"lines", "false"}, {"theme", theme}, {"histogram", "false"}},
                440, 440);
            const double radius = 200;
            for (const double z : {-0.6, -0.3, 0.0, 0.3, 0.6}) {
                const auto colour = colour_at(colour_map("viridis"), (z + 1) / 2);
                const auto seen = colour_at(image, 220, 220 - static_cast<int>(radius * z));
                EXPECT_LT(apart(seen, {colour[0], colour[1], colour[2]}), 16) << theme << ", z = " << z;
            }
        }
}

TEST(Globe, IsDarkerTowardsItsLimbButNeverBlack) {
    Snapshot snapshot = xn_globe(cubed_globe(16, 2), 1.01);
    const Image image = globe_image(
        snapshot, {{"camera", look}, {"lines", "false"}, {"color", "none"}, {"theme", "light"}}, 440, 440);
    int last = 256;
    for (const double r : {0.0, 0.4, 0.7, 0.9, 0.97}) {
        const int here = colour_at(image, 220 + static_cast<int>(200 * r), 220)[1];
        EXPECT_LE(here, last) << r;
        last = here;
    }
    EXPECT_LT(last, 225) << "a ball, not a disc";
    EXPECT_GT(last, 130);
}

TEST(Globe, IsOpaqueAndRound) {
    // What lies behind is another colour, and never seen; the outline is a circle to within a pixel.
    for (const int k : {2, 8}) {
        Snapshot snapshot = xn_globe(cubed_globe(k, 2), 1.01);
        for (std::size_t i = 0; i < snapshot.x.size(); ++i)
            snapshot.fields[0].values[i] = snapshot.x[i].x > -0.3 ? 0 : 1;
        const Image image = globe_image(
            snapshot, {{"camera", look}, {"lines", "false"}, {"color_map", "grey"}, {"histogram", "false"}},
            440, 440);
        const auto background = colour_at(image, 2, 2);
        for (int y = 20; y < 400; y += 3)
            for (int x = 20; x < 350; x += 3) { // beside the legend
                const double r = std::hypot(x + 0.5 - 220, y + 0.5 - 220);
                const auto seen = colour_at(image, x, y);
                if (r < 198) {
                    EXPECT_LT(seen[1], 40) << "the front is black";
                    EXPECT_NE(seen, background);
                }
                if (r > 202) {
                    EXPECT_EQ(seen, background) << x << ", " << y;
                }
            }
    }
}

/// How much ink lines leave in a square around a place, in parts of white.
double ink(const Image& with, const Image& without, int x, int y, int half) {
    double sum = 0;
    for (int j = y - half; j <= y + half; ++j)
        for (int i = x - half; i <= x + half; ++i)
            sum += apart(colour_at(with, i, j), colour_at(without, i, j));
    return sum / (255.0 * (2 * half + 1) * (2 * half + 1));
}

TEST(Globe, LinesFadeAtTheLimbAndNeverSink) {
    for (const int k : {8, 16, 64}) {
        const Snapshot snapshot = xn_globe(cubed_globe(k, 2), 1.01);
        const Settings settings = {{"camera", look}, {"color", "none"}, {"theme", "light"}};
        Settings bare = settings;
        bare.emplace_back("lines", "false");
        const Image with = globe_image(snapshot, settings, 440, 440),
                    without = globe_image(snapshot, bare, 440, 440);
        double middle = 0, limb = 0;
        for (int i = 0; i < 24; ++i) {
            const double angle = 2 * std::numbers::pi * i / 24;
            const auto at = [&](double r) { return 220 + static_cast<int>(std::lround(r)); };
            middle += ink(with, without, at(90 * std::cos(angle)), at(90 * std::sin(angle)), 9) / 24;
            limb += ink(with, without, at(196 * std::cos(angle)), at(196 * std::sin(angle)), 1) / 24;
        }
        EXPECT_GT(middle, 0.02) << k;
        EXPECT_LT(limb, k == 64 ? 0.12 : 0.08) << k << ": no black rim";
    }
    // An edge of coarse, curved cells is there all along: no part of it lies below the faces.
    const Snapshot coarse = xn_globe(cubed_globe(2, 2), 1.01);
    const Settings settings = {{"camera", look}, {"color", "none"}, {"theme", "light"}};
    Settings bare = settings;
    bare.emplace_back("lines", "false");
    const Image with = globe_image(coarse, settings, 440, 440), without = globe_image(coarse, bare, 440, 440);
    for (int y = 100; y < 340; ++y) EXPECT_GT(ink(with, without, 220, y, 2), 0.05) << y;
}

TEST(Globe, BlendsAlongTheBall) {
    // Half of a long displacement: along a straight line, the globe would be dented.
    Snapshot snapshot = xn_globe(cubed_globe(8, 2), 16);
    const Image image = globe_image(
        snapshot, {{"blend", "0.5"}, {"camera", look}, {"color", "none"}, {"lines", "false"}}, 440, 440);
    const auto background = colour_at(image, 2, 2);
    for (int i = 0; i < 60; ++i) {
        const double angle = 2 * std::numbers::pi * i / 60;
        const auto at = [&](double r, double way) { return static_cast<int>(220 + r * way); };
        EXPECT_NE(colour_at(image, at(197, std::cos(angle)), at(197, std::sin(angle))), background) << i;
    }
}

TEST(Globe, OfAnyRadiusLooksTheSame) {
    for (const double radius : {6371e3, 1e-4}) {
        Snapshot snapshot = xn_globe(cubed_globe(8, 2), 2);
        Mesh mesh = *snapshot.mesh;
        for (auto* x :
             {&mesh.nodes.x, &mesh.nodes.y, &mesh.nodes.z, &snapshot.x.x, &snapshot.x.y, &snapshot.x.z})
            for (double& value : *x) value *= radius;
        snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
        EXPECT_EQ(difference(globe_image(snapshot, {}), stored("globe-x2")), "") << radius;
    }
}

TEST(Globe, HasARimWhereItIsAsDarkAsWhatIsBehind) {
    const Theme theme = dark_theme();
    const auto byte = [](float part) { return static_cast<int>(std::lround(255 * part)); };
    const std::array<int, 3> ground{byte(theme.background.r), byte(theme.background.g),
                                    byte(theme.background.b)};
    const Image image =
        globe_image(xn_globe(cubed_globe(8, 2), 16),
                    {{"camera", "centre 0 0 0 height 2.2 right 0 -1 0 up 0 0 1"}, {"lines", "false"}});
    const double radius = image.height / 2.2; // seen from -x, where the monitor is lowest
    for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24 + 0.1;
        if (std::cos(angle) > 0.5 || std::sin(angle) < -0.8) continue; // under legend and caption
        int most = 0;
        for (double r = radius - 2; r <= radius + 2; r += 0.5) {
            const int x = static_cast<int>(image.width / 2 + r * std::cos(angle)),
                      y = static_cast<int>(image.height / 2 - r * std::sin(angle));
            most = std::max(most, apart(colour_at(image, x, y), ground));
        }
        EXPECT_GT(most, 50) << i;
    }
}

TEST(Globe, TangledCellsShowWhereTheyAre) {
    const auto magenta = [](const Image& image) {
        int found = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            found += image.rgba[i] + image.rgba[i + 2] - 2 * image.rgba[i + 1] > 200; // no colour of the map
        return found;
    };
    const Snapshot snapshot = tangled_globe(10);
    EXPECT_GT(magenta(globe_image(snapshot, {})), 3000);
    EXPECT_GT(magenta(globe_image(snapshot, {{"layout", "projection"}})), 1500);
    // From behind only the note has the colour.
    const std::string behind = "centre 0 0 0 height 2.2 right 0 -1 0 up 0.5 0 0.866";
    const int swatch = magenta(globe_image(snapshot, {{"camera", behind}}));
    EXPECT_GT(swatch, 20);
    EXPECT_LT(swatch, 300);
    EXPECT_EQ(magenta(globe_image(xn_globe(cubed_globe(8, 2), 16), {})), 0) << "far moved is not tangled";
}

} // namespace
} // namespace gaspard
