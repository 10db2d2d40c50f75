#include "core/base/error.hpp"
#include "core/tessellate/colour_map.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

using Colour = std::array<unsigned char, 3>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ColourMap, ViridisRunsFromItsPublishedFirstToItsLastColour) {
    const ColourMap& viridis = colour_map("viridis");
    EXPECT_EQ(viridis.colours.size(), 256U);
    EXPECT_EQ(colour_at(viridis, 0), (Colour{68, 1, 84}));
    EXPECT_EQ(colour_at(viridis, 1), (Colour{253, 231, 37}));
    EXPECT_EQ(colour_at(viridis, 128.0 / 255), (Colour{33, 145, 140}));
}

TEST(ColourMap, PositionsOutsideTheMapTakeItsEndsAndNanTheLowest) {
    const ColourMap& viridis = colour_map("viridis");
    EXPECT_EQ(colour_at(viridis, -3), colour_at(viridis, 0));
    EXPECT_EQ(colour_at(viridis, 7), colour_at(viridis, 1));
    EXPECT_EQ(colour_at(viridis, nan), colour_at(viridis, 0));
}

TEST(ColourMap, BetweenTwoColoursLiesTheirMean) {
    const Colour colours[] = {{0, 100, 200}, {100, 100, 0}};
    EXPECT_EQ(colour_at({"two", colours}, 0.5), (Colour{50, 100, 100}));
    EXPECT_EQ(colour_at({"two", colours}, 0.25), (Colour{25, 100, 150}));
}

TEST(ColourMap, BrightnessOfViridisGrows) {
    const ColourMap& viridis = colour_map("viridis");
    double last = 0;
    for (int i = 0; i <= 16; ++i) {
        const Colour c = colour_at(viridis, i / 16.0);
        const double brightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
        EXPECT_GT(brightness, last);
        last = brightness;
    }
}

TEST(ColourMap, AnUnknownNameIsOurFault) { EXPECT_THROW(colour_map("rainbow"), InternalError); }

TEST(ColourRange, SpansTheFiniteValues) {
    const double values[] = {3, nan, -1, std::numeric_limits<double>::infinity(), 2};
    EXPECT_EQ(range_of(values), (ColourRange{-1, 3}));
    EXPECT_DOUBLE_EQ(range_of(values).position(0), 0.25);
}

TEST(ColourRange, OfNothingOrOfEqualValuesStillGivesPositions) {
    EXPECT_EQ(range_of({}), (ColourRange{0, 1}));
    const double equal[] = {5, 5};
    EXPECT_EQ(range_of(equal).position(5), 0.5);
}

} // namespace
} // namespace gaspard
