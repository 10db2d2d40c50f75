// The pictures of the scenarios, and how they reach the screen.
#include "core/scenario/catalogue.hpp"
#include "core/scenario/toml.hpp"
#include "gui/app/thumbnails.hpp"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>

namespace gaspard {
namespace {

TEST(Thumbnails, EveryBuiltInScenarioHasOneOfTheRightSize) {
    std::size_t bytes = 0;
    for (const BuiltinScenario& one : builtin_scenarios()) {
        const std::string_view file = thumbnail_file(one.name);
        ASSERT_FALSE(file.empty()) << one.name << ": scripts/thumbnails.sh draws it";
        const Image image = decode_png(file, std::string(one.name));
        EXPECT_EQ(image.width, thumbnail_width) << one.name;
        EXPECT_EQ(image.height, thumbnail_height) << one.name;
        std::set<std::uint32_t> colours;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            colours.insert(image.rgba[i] * 65536U + image.rgba[i + 1] * 256U + image.rgba[i + 2]);
        EXPECT_GT(colours.size(), 20U) << one.name << " shows something";
        bytes += file.size();
    }
    EXPECT_LT(bytes, 500'000U);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(GASPARD_SOURCE_DIR "/assets/thumbnails"))
        files += entry.path().extension() == ".png" ? 1 : 0;
    EXPECT_EQ(files, builtin_scenarios().size()) << "none is left over";
    EXPECT_TRUE(thumbnail_file("no-such-scenario").empty());
}

TEST(Thumbnails, AFewComeWithEachFrame) {
    Thumbnails thumbnails;
    std::size_t found = 0;
    int frames = 0;
    for (bool waiting = true; waiting; ++frames) {
        thumbnails.begin_frame();
        const std::size_t before = found;
        found = 0;
        for (const BuiltinScenario& one : builtin_scenarios()) found += thumbnails.find(one.name) ? 1 : 0;
        EXPECT_LE(found - before, 8U);
        waiting = thumbnails.waiting();
        ASSERT_LT(frames, 100);
    }
    EXPECT_EQ(found, builtin_scenarios().size());
    EXPECT_GT(frames, 3);
}

TEST(PictureSheet, PicturesLieBesideEachOther) {
    const auto sheet = std::make_shared<PictureSheet>(3, 2, 5);
    std::vector<PicturePlace> places;
    for (int i = 0; i < 5; ++i) {
        const auto value = static_cast<std::uint8_t>(10 * (i + 1));
        places.push_back(sheet->add({3, 2, std::vector<std::uint8_t>(24, value)}));
        EXPECT_EQ(sheet->version(), static_cast<std::uint64_t>(i + 1));
    }
    const Image& all = sheet->image();
    for (int i = 0; i < 5; ++i) {
        const PicturePlace& place = places[static_cast<std::size_t>(i)];
        const auto x = [&](float at) {
            return static_cast<int>(std::lround(at * static_cast<float>(all.width)));
        };
        const auto y = [&](float at) {
            return static_cast<int>(std::lround(at * static_cast<float>(all.height)));
        };
        EXPECT_EQ(x(place.high.x) - x(place.low.x), 3);
        EXPECT_EQ(y(place.high.y) - y(place.low.y), 2);
        for (int row = y(place.low.y); row < y(place.high.y); ++row)
            for (int column = x(place.low.x); column < x(place.high.x); ++column)
                EXPECT_EQ(all.rgba[static_cast<std::size_t>(4 * (row * all.width + column))], 10 * (i + 1));
    }
}

} // namespace
} // namespace gaspard
