#include "core/base/error.hpp"
#include "core/tessellate/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

using Colour = std::array<unsigned char, 3>;
using Numbers = std::array<double, 3>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ColourMap, ViridisRunsFromItsPublishedFirstToItsLastColour) {
    const ColourMap& viridis = colour_map("viridis");
    EXPECT_EQ(viridis.colours.size(), 256U);
    EXPECT_EQ(colour_at(viridis, 0), (Colour{68, 1, 84}));
    EXPECT_EQ(colour_at(viridis, 1), (Colour{253, 231, 37}));
    EXPECT_EQ(colour_at(viridis, 128.0 / 255), (Colour{33, 145, 140}));
    EXPECT_EQ(colour_at(colour_map("plasma"), 0), (Colour{13, 8, 135}));
    EXPECT_EQ(colour_at(colour_map("plasma"), 1), (Colour{240, 249, 33}));
}

TEST(ColourMap, ClampsPositionsAndMapsNanToTheLowestColour) {
    const ColourMap& viridis = colour_map("viridis");
    EXPECT_EQ(colour_at(viridis, -3), colour_at(viridis, 0));
    EXPECT_EQ(colour_at(viridis, 7), colour_at(viridis, 1));
    EXPECT_EQ(colour_at(viridis, nan), colour_at(viridis, 0));
}

TEST(ColourMap, InterpolatesBetweenColours) {
    const Colour colours[] = {{0, 100, 200}, {100, 100, 0}};
    EXPECT_EQ(colour_at({"two", colours}, 0.5), (Colour{50, 100, 100}));
    EXPECT_EQ(colour_at({"two", colours}, 0.25), (Colour{25, 100, 150}));
}

TEST(ColourMap, HasSixMapsOfWhichTheFirstIsSequential) {
    ASSERT_EQ(colour_maps().size(), 6U);
    EXPECT_EQ(colour_maps().front().name, "viridis");
    EXPECT_EQ(std::count_if(colour_maps().begin(), colour_maps().end(),
                            [](const ColourMap& map) { return map.diverging; }),
              1);
}

TEST(ColourMap, UnknownNamesAreInternalErrors) { EXPECT_THROW(colour_map("rainbow"), InternalError); }

// Perceived colour: OKLab (Ottosson 2020), and a simulation of vision without red or without green
// cones (Viénot, Brettel and Mollon 1999).

Numbers linear(Colour c) {
    Numbers out{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double v = c[i] / 255.0;
        out[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    return out;
}

Numbers times(const std::array<Numbers, 3>& matrix, Numbers v) {
    Numbers out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) out[i] += matrix[i][k] * v[k];
    return out;
}

Numbers oklab(Numbers rgb) {
    Numbers lms = times({{{0.4122214708, 0.5363325363, 0.0514459929},
                          {0.2119034982, 0.6806995451, 0.1073969566},
                          {0.0883024619, 0.2817188376, 0.6299787005}}},
                        rgb);
    for (double& v : lms) v = std::cbrt(v);
    return times({{{0.2104542553, 0.7936177850, -0.0040720468},
                   {1.9779984951, -2.4285922050, 0.4505937099},
                   {0.0259040371, 0.7827717662, -0.8086757660}}},
                 lms);
}

constexpr std::array<Numbers, 3> to_cones = {
    {{17.8824, 43.5161, 4.11935}, {3.45565, 27.1554, 3.86714}, {0.0299566, 0.184309, 1.46709}}};
constexpr std::array<Numbers, 3> from_cones = {{{0.0809444479, -0.130504409, 0.116721066},
                                                {-0.0102485335, 0.0540193266, -0.113614708},
                                                {-0.000365296938, -0.00412161469, 0.693511405}}};
Numbers without_red(Numbers rgb) {
    Numbers lms = times(to_cones, rgb);
    lms[0] = 2.02344 * lms[1] - 2.52581 * lms[2];
    return times(from_cones, lms);
}
Numbers without_green(Numbers rgb) {
    Numbers lms = times(to_cones, rgb);
    lms[1] = 0.494207 * lms[0] + 1.24827 * lms[2];
    return times(from_cones, lms);
}

double distance(Numbers a, Numbers b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

constexpr int steps = 16;
using Sight = std::function<Numbers(Numbers)>;
const Sight usual = [](Numbers rgb) { return rgb; };

std::vector<Numbers> seen(const ColourMap& map, const Sight& sight = usual) {
    std::vector<Numbers> path;
    for (int i = 0; i <= steps; ++i)
        path.push_back(oklab(sight(linear(colour_at(map, static_cast<double>(i) / steps)))));
    return path;
}

/// The smallest and the largest step relative to the mean step.
std::pair<double, double> evenness(const std::vector<Numbers>& path) {
    double sum = 0, low = 1e300, high = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double step = distance(path[i], path[i + 1]);
        sum += step, low = std::min(low, step), high = std::max(high, step);
    }
    return {low * steps / sum, high * steps / sum};
}

TEST(ColourMap, IsPerceptuallyUniform) {
    for (const ColourMap& map : colour_maps()) {
        const auto [low, high] = evenness(seen(map));
        EXPECT_GT(low, 0.85) << map.name;
        EXPECT_LT(high, 1.25) << map.name;
    }
    // As a rainbow map does.
    const Colour rainbow[] = {{0, 0, 128},   {0, 0, 255}, {0, 255, 255},
                              {255, 255, 0}, {255, 0, 0}, {128, 0, 0}};
    const auto [low, high] = evenness(seen({"rainbow", rainbow}));
    EXPECT_LT(low, 0.6);
    EXPECT_GT(high, 1.5);
}

TEST(ColourMap, LightnessIsMonotonic) {
    for (const ColourMap& map : colour_maps()) {
        const auto path = seen(map);
        const auto step = [&](std::size_t i) { return path[i + 1][0] - path[i][0]; };
        for (std::size_t i = 0; i < steps; ++i) {
            const bool upper = map.diverging && i >= steps / 2;
            const double first = upper ? -step(0) : step(0); // diverging maps reverse at the middle
            EXPECT_GT(step(i) * first, 0) << map.name << " at " << i;
            EXPECT_GT(std::abs(step(i)), 0.015) << map.name << " at " << i;
        }
        if (map.diverging) {
            EXPECT_NEAR(path.front()[0], path.back()[0], 0.01) << map.name;
            EXPECT_LT(std::hypot(path[steps / 2][1], path[steps / 2][2]), 0.02)
                << map.name << ": a grey middle";
        }
    }
}

TEST(ColourMap, BlueYellowIsSafeForColourBlindness) {
    const auto changed = [](std::string_view name, const Sight& sight) {
        const auto before = seen(colour_map(name)), after = seen(colour_map(name), sight);
        double sum = 0;
        for (std::size_t i = 0; i < before.size(); ++i) sum += distance(before[i], after[i]);
        return sum / static_cast<double>(before.size());
    };
    for (const Sight& sight : {Sight(without_red), Sight(without_green)}) {
        EXPECT_LT(changed("blue-yellow", sight), 0.03);
        EXPECT_GT(changed("plasma", sight), 0.08) << "a map that is not made for them";
        const auto [low, high] = evenness(seen(colour_map("blue-yellow"), sight));
        EXPECT_GT(low, 0.85);
        EXPECT_LT(high, 1.15);
    }
}

TEST(ColourRange, SpansTheFiniteValues) {
    const double values[] = {3, nan, -1, std::numeric_limits<double>::infinity(), 2};
    EXPECT_EQ(range_of(values), (ColourRange{-1, 3}));
    EXPECT_DOUBLE_EQ(range_of(values).position(0), 0.25);
    EXPECT_DOUBLE_EQ(range_of(values).value(0.25), 0);
}

TEST(ColourRange, IsDefinedForNoValuesAndForEqualValues) {
    EXPECT_EQ(range_of({}), (ColourRange{0, 1}));
    const double equal[] = {5, 5};
    EXPECT_EQ(range_of(equal).position(5), 0.5);
}

TEST(ColourRange, LogarithmicRangesMapEqualFactorsToEqualSteps) {
    const ColourRange range{0.01, 100, true};
    EXPECT_DOUBLE_EQ(range.position(0.1), 0.25);
    EXPECT_DOUBLE_EQ(range.position(1), 0.5);
    EXPECT_DOUBLE_EQ(range.value(0.75), 10);
    EXPECT_EQ(range.position(-3), 0) << "there is no logarithm";
}

} // namespace
} // namespace gaspard
