#include "core/base/error.hpp"
#include "core/monitor/image_monitor.hpp"
#include "support/solved_run.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// Black on the left half, white on the right.
GreyImage halves() {
    GreyImage image{64, 64, std::vector<float>(64 * 64), 64, 64, "PNG"};
    for (std::size_t i = 0; i < image.grey.size(); ++i) image.grey[i] = i % 64 < 32 ? 0.0F : 1.0F;
    return image;
}

double picture_at(const Monitor& monitor, Vec3 x) {
    Points p(1);
    p.set(0, x);
    double value = 0;
    monitor.values(p, {&value, 1});
    return value;
}

const DataContext picture_walls{.space = {SpaceKind::euclidean}};

TEST(ImageMonitor, IsDenseWhereThePictureIsDark) {
    const auto dark = image_monitor(halves(), {.contrast = 30}, picture_walls);
    EXPECT_NEAR(picture_at(*dark, {0.1, 0.5, 0}), 30, 0.01);
    EXPECT_NEAR(picture_at(*dark, {0.9, 0.5, 0}), 1, 0.01);
    const auto bright = image_monitor(halves(), {.image = {.invert = true}, .contrast = 30}, picture_walls);
    EXPECT_NEAR(picture_at(*bright, {0.1, 0.5, 0}), 1, 0.01);
    EXPECT_NEAR(picture_at(*bright, {0.9, 0.5, 0}), 30, 0.01);
}

TEST(ImageMonitor, HasTheGradientsOfItsValues) {
    const auto monitor = image_monitor(halves(), {.contrast = 30}, picture_walls);
    for (const double x : {0.3, 0.45, 0.5, 0.52, 0.6}) {
        Points p(1), g;
        p.set(0, {x, 0.4, 0});
        monitor->gradients(p, g);
        const double h = 1e-6;
        const double slope =
            (picture_at(*monitor, {x + h, 0.4, 0}) - picture_at(*monitor, {x - h, 0.4, 0})) / (2 * h);
        EXPECT_NEAR(g.x[0], slope, 1e-5 * (1 + std::abs(slope)));
    }
}

TEST(ImageMonitor, IsBlurredUntilItIsNotTooSteep) {
    const auto note = [](double contrast, const Space& space) {
        return image_monitor(halves(), {.contrast = contrast}, {.space = space})->report().notes.at(0);
    };
    EXPECT_EQ(note(3, picture_walls.space),
              "The picture is blurred over 1 cell, so that the mesh can follow.");
    const std::string strong = note(500, picture_walls.space), sphere = note(20, {SpaceKind::sphere});
    EXPECT_NE(strong.find(" cells instead of 1, so that the mesh can follow."), std::string::npos) << strong;
    EXPECT_NE(sphere.find(" cells instead of 1, so that the mesh can follow."), std::string::npos) << sphere;
}

TEST(ImageMonitor, AdaptsMeshesOfEveryKindToPictures) {
    for (const auto& [name, settings] :
         {std::pair<std::string, std::vector<std::string>>{"plane-portrait", {"domain.cells=32"}},
          {"plane-portrait", {"domain.cells=32", "domain.boundary=periodic"}},
          {"sphere-relief", {"domain.cells=12"}},
          {"spline-portrait", {"domain.cells=16"}},
          {"spline-torus",
           {"domain.cells=12", "monitor.type=image", "monitor.file=gaspard:portrait.png", "method.type=auto",
            "monitor.contrast=5"}}}) {
        const gaspard::Run run = solved_run(name, settings);
        EXPECT_EQ(run.status(), RunStatus::converged) << name;
        EXPECT_EQ(run.history().back().tangled_cells, 0u) << name;
        EXPECT_GT(run.history().back().iteration, 2) << name;
    }
}

} // namespace
} // namespace gaspard
