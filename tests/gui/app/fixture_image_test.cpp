// Offscreen images of the fixtures: cells that no shipped domain has are drawn where they should be.
#include "core/fixtures/fixture_run.hpp"
#include "core/tessellate/camera.hpp"
#include "gui/app/viewport_image.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

/// The pixels that are not background, row by row; the background is what the corner shows.
struct Silhouette {
    int left = 1 << 30, right = -1, top = 1 << 30, bottom = -1;
    double pixels = 0; ///< between the first and the last drawn pixel of each row

    explicit Silhouette(const Image& image) {
        const auto pixel = [&](int x, int y) {
            return image.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
        };
        for (int y = 0; y < image.height; ++y) {
            int first = image.width, last = -1;
            for (int x = 0; x < image.width; ++x) {
                if (std::equal(pixel(x, y), pixel(x, y) + 3, pixel(0, 0))) continue;
                first = std::min(first, x);
                last = x;
            }
            if (last < 0) continue;
            left = std::min(left, first), right = std::max(right, last);
            top = std::min(top, y), bottom = y;
            pixels += last - first + 1;
        }
    }
    double width() const { return right - left + 1; }
    double height() const { return bottom - top + 1; }
    /// The part of the surrounding rectangle that is covered.
    double covered() const { return pixels / (width() * height()); }
};

Image draw(const std::string& domain, int cells, const std::string& colour) {
    gaspard::Run run = finished_fixture_run(domain, cells);
    return render_panels({MeshPanel{.title = {}, .snapshot = run.snapshot(), .colour = colour, .blend = 1}},
                         1, 400, 400);
}

Silhouette silhouette(const std::string& domain, int cells) {
    return Silhouette(draw(domain, cells, "none"));
}

// Lines are a few pixels wide, which is what the tolerances are for.

TEST(FixturePicture, TheSphereIsRound) {
    const Silhouette seen = silhouette("sphere", 4);
    EXPECT_GT(seen.width(), 200);
    EXPECT_NEAR(seen.width() / seen.height(), 1, 0.01);
    EXPECT_NEAR(seen.covered(), std::numbers::pi / 4, 0.01);
}

TEST(FixturePicture, TheDiskIsAPolygonOf24Corners) {
    const Silhouette seen = silhouette("disk", 4);
    EXPECT_GT(seen.width(), 200);
    EXPECT_NEAR(seen.width() / seen.height(), 1, 0.01);
    EXPECT_NEAR(seen.covered(), 12 * std::sin(std::numbers::pi / 12) / 4, 0.01);
}

TEST(FixturePicture, TheCubeIsTheHexagonThatTheCameraSees) {
    const Silhouette seen = silhouette("cube", 4);
    EXPECT_GT(seen.width(), 200);
    const Camera camera = spatial_home({{0, 0, 0}, {1, 1, 1}}, {400, 400});
    const auto sum = [](Vec3 v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    // A unit face is seen with the area |normal . view|, and an edge spans |edge . right| and |edge . up|.
    const double hexagon = sum(cross(camera.right, camera.up)),
                 rectangle = sum(camera.right) * sum(camera.up);
    EXPECT_NEAR(seen.covered(), hexagon / rectangle, 0.01);
    EXPECT_NEAR(seen.width() / seen.height(), sum(camera.right) / sum(camera.up), 0.01);
}

TEST(FixturePicture, TheIntervalIsPlotted) {
    const Silhouette seen = silhouette("line", 12);
    EXPECT_GT(seen.width(), 350);
    EXPECT_GT(seen.height(), 350);
}

TEST(FixturePicture, FacesAreFilled) {
    for (const char* domain : {"sphere", "cube", "disk"}) {
        const Image image = draw(domain, 4, "monitor");
        const auto background = [&](int x, int y) {
            const auto* pixel = image.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
            return std::equal(pixel, pixel + 3, image.rgba.data());
        };
        int holes = 0;
        for (int y = 150; y < 250; ++y)
            for (int x = 150; x < 250; ++x) holes += background(x, y);
        EXPECT_EQ(holes, 0) << domain;
    }
}

TEST(FixturePicture, IsColouredByFieldsOfTheMethod) {
    const auto catalogue = std::make_shared<const Catalogue>(fixture_catalogue());
    Scenario scenario = default_scenario(*catalogue);
    apply_settings(*catalogue, scenario,
                   {"domain.type=disk", "domain.cells=4", "monitor.type=band", "method.type=springs",
                    "method.max_iterations=20", "view.lines=false"});
    gaspard::Run run(catalogue, scenario);
    run.solve();
    const auto snapshot = run.snapshot();
    const auto drawn = [&](const std::string& colour) {
        Values view = scenario.view;
        view.set("color", colour);
        return render_view(*snapshot, view, 400, 300, "disk");
    };
    const auto differing = [](const Image& a, const Image& b) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.rgba.size(); i += 4)
            count += std::equal(a.rgba.data() + i, a.rgba.data() + i + 4, b.rgba.data() + i) ? 0 : 1;
        return count;
    };
    const Image force = drawn("force"), strain = drawn("strain");
    EXPECT_EQ(differing(strain, drawn("strain")), 0U);
    EXPECT_GT(differing(strain, drawn("monitor")), 5000U);
    EXPECT_GT(differing(strain, drawn("none")), 5000U);
    EXPECT_GT(differing(force, strain), 5000U);
    const auto panel = [&](const std::string& colour) {
        return render_panels({MeshPanel{.title = {}, .snapshot = snapshot, .colour = colour, .blend = 1}}, 1,
                             400, 400);
    };
    EXPECT_GT(differing(panel("strain"), panel("force")), 5000U);
}

} // namespace
} // namespace gaspard
