#include "core/base/error.hpp"
#include "core/function/image_function.hpp"
#include "core/function/smoothing.hpp"
#include "support/picture_files.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// A picture of one grey, with another one in a rectangle of pixels.
GreyImage picture(std::size_t width, std::size_t height, float ground, float spot, std::size_t x0,
                  std::size_t y0, std::size_t x1, std::size_t y1) {
    GreyImage image{width, height, std::vector<float>(width * height, ground), width, height, "PNG"};
    for (std::size_t y = y0; y < y1; ++y)
        for (std::size_t x = x0; x < x1; ++x) image.grey[y * width + x] = spot;
    return image;
}

double at(const MadeFunction& made, Vec3 x) {
    Points p(1);
    p.set(0, x);
    double value = 0;
    made.function->values(p, {&value, 1});
    return value;
}

const DataContext walls{.space = {SpaceKind::euclidean}};
const ImageOptions sharp{.blur = 0};

TEST(ImageFunction, StandsAsOnTheScreen) {
    // White in the upper left quarter.
    const auto u = image_function(picture(100, 100, 0, 1, 0, 0, 50, 50), sharp, walls);
    EXPECT_NEAR(at(u, {0.25, 0.75, 0}), 1, 1e-3);
    EXPECT_NEAR(at(u, {0.75, 0.75, 0}), 0, 1e-3);
    EXPECT_NEAR(at(u, {0.25, 0.25, 0}), 0, 1e-3);
    EXPECT_NEAR(at(u, {0.5, 0.75, 0}), 0.5, 1e-3); // the edge is where it was
}

TEST(ImageFunction, FitsFillsAndStretches) {
    // Twice as wide as high; white in the left quarter of the width.
    const GreyImage wide = picture(200, 100, 0, 1, 0, 0, 50, 100);
    ImageOptions options = sharp;
    options.fit = ImageFit::stretch;
    EXPECT_NEAR(at(image_function(wide, options, walls), {0.25, 0.5, 0}), 0.5, 1e-3);
    options.fit = ImageFit::fit; // half as high as the square, its edges go on
    EXPECT_NEAR(at(image_function(wide, options, walls), {0.25, 0.5, 0}), 0.5, 1e-3);
    EXPECT_NEAR(at(image_function(wide, options, walls), {0.1, 0.95, 0}), 1, 1e-3);
    options.fit = ImageFit::fill; // the white quarter is cut off at the left
    EXPECT_NEAR(at(image_function(wide, options, walls), {0.1, 0.5, 0}), 0, 1e-2);
    const GreyImage narrow = picture(100, 200, 0, 1, 0, 50, 100, 100); // white above the middle
    EXPECT_NEAR(at(image_function(narrow, options, walls), {0.5, 0.75, 0}), 1, 1e-3);
    EXPECT_NEAR(at(image_function(narrow, options, walls), {0.5, 0.25, 0}), 0, 1e-3);
}

TEST(ImageFunction, TonesInOrder) {
    const GreyImage grey = picture(50, 50, 0.25F, 0.25F, 0, 0, 0, 0);
    ImageOptions options = sharp;
    EXPECT_NEAR(at(image_function(grey, options, walls), {0.3, 0.3, 0}), 0.25, 1e-9);
    options.gamma = 2;
    EXPECT_NEAR(at(image_function(grey, options, walls), {0.3, 0.3, 0}), 0.0625, 1e-9);
    options.invert = true;
    EXPECT_NEAR(at(image_function(grey, options, walls), {0.3, 0.3, 0}), 0.5625, 1e-9);
    options.floor = 0.7;
    EXPECT_NEAR(at(image_function(grey, options, walls), {0.3, 0.3, 0}), 0.7, 1e-9);
}

TEST(ImageFunction, BlursByCellsOrPixels) {
    // A vertical edge, blurred by sigma: Phi((x - 1/2) / sigma).
    const GreyImage edge = picture(1000, 1000, 0, 1, 500, 0, 1000, 1000);
    const double cell = 1 / 60.0; // without a mesh
    const auto phi = [](double t) { return 0.5 * std::erfc(-t / std::sqrt(2.0)); };
    ImageOptions options{.blur = 4};
    EXPECT_NEAR(at(image_function(edge, options, walls), {0.55, 0.5, 0}), phi(0.05 / (4 * cell)), 3e-3);
    options = {.blur = 100, .blur_unit = LengthUnit::pixels};
    const auto u = image_function(edge, options, walls);
    EXPECT_NEAR(at(u, {0.55, 0.5, 0}), phi(0.05 / 0.1), 3e-3);
    ASSERT_EQ(u.notes.size(), 1u);
    EXPECT_EQ(u.notes[0], "The picture is blurred over 6 cells, so that the mesh can follow.");
    options = {.blur = 1, .blur_unit = LengthUnit::pixels};
    EXPECT_EQ(image_function(edge, options, walls).notes[0],
              "The picture is blurred over 1 cell instead of 1 pixel, so that the mesh can follow.");
}

TEST(ImageFunction, IsSmoothAcrossTheEdgesOfThePeriodicPlane) {
    const GreyImage edge = picture(100, 100, 0, 1, 50, 0, 100, 100);
    const auto u = image_function(edge, {}, {.space = {SpaceKind::periodic_square}});
    EXPECT_NEAR(at(u, {0, 0.5, 0}), 0.5, 1e-3);
    EXPECT_NEAR(at(u, {1, 0.5, 0}), at(u, {0, 0.5, 0}), 1e-12);
    ASSERT_EQ(u.notes.size(), 2u);
    EXPECT_NE(u.notes[1].find("blurred into each other"), std::string::npos);
}

TEST(ImageFunction, IsAMapOfTheSphere) {
    // White between 0 and 90 degrees east on the northern hemisphere of a map that begins at -180.
    const GreyImage map = picture(360, 180, 0, 1, 180, 0, 270, 90);
    const DataContext sphere{.space = {SpaceKind::sphere}};
    const auto u = image_function(map, sharp, sphere);
    EXPECT_NEAR(at(u, at_latitude_longitude(45, 45)), 1, 1e-3);
    EXPECT_NEAR(at(u, at_latitude_longitude(-45, 45)), 0, 1e-3);
    EXPECT_NEAR(at(u, at_latitude_longitude(45, -135)), 0, 1e-3);
    ImageOptions turned = sharp;
    turned.left_longitude = 0; // white from 180 to 270
    EXPECT_NEAR(at(image_function(map, turned, sphere), at_latitude_longitude(45, -135)), 1, 1e-3);
    EXPECT_NEAR(at(u, {0, 0, 1}), 0.25, 0.02); // the mean around the pole
}

TEST(ImageFunction, ReadsFilesOnceAndNamesTheRow) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.png";
    std::ofstream(path, std::ios::binary) << png_bytes({.width = 2, .height = 1}, {{0, 255}});
    DataContext context{.space = {SpaceKind::euclidean}, .folder = folder.path()};
    context.files = std::make_shared<FileCache>();
    const auto first = read_image("a.png", "monitor.file", context);
    EXPECT_EQ(first->width, 2u);
    EXPECT_EQ(read_image("a.png", "monitor.file", context), first); // the same content
    EXPECT_EQ(read_image("gaspard:portrait.png", "monitor.file", context)->width, 384u);
    const auto message = [&](const std::string& file) {
        try {
            read_image(file, "monitor.file", context);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message(""), "monitor.file is empty; it is the path of a PNG or JPEG picture");
    EXPECT_NE(message("missing.png").find("missing.png"), std::string::npos);
    EXPECT_EQ(message("gaspard:none.png"), "the program has no file gaspard:none.png");
}

} // namespace
} // namespace gaspard
