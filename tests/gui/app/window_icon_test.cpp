#include "gui/app/window_icon.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(WindowIcon, IsAMeshOnASquareWithRoundCorners) {
    for (const int size : {16, 48, 128}) {
        const Image icon = window_icon(size);
        ASSERT_EQ(icon.rgba.size(), static_cast<std::size_t>(4 * size * size));
        EXPECT_EQ(icon.rgba[3], 0) << "the corner is transparent";
        std::size_t yellow = 0, dark = 0;
        for (std::size_t i = 0; i < icon.rgba.size(); i += 4) {
            if (icon.rgba[i + 3] < 255) continue;
            yellow += icon.rgba[i] > 150 && icon.rgba[i + 2] < 120;
            dark += icon.rgba[i] < 80;
        }
        EXPECT_GT(yellow, icon.rgba.size() / 40) << size;
        EXPECT_GT(dark, icon.rgba.size() / 40) << size;
    }
}

} // namespace
} // namespace gaspard
