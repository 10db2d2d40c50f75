// Axes of meshes in the plane: where their labels are, and what they leave out.
#include "core/mesh/mesh.hpp"
#include "core/tessellate/plane_axes.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

double width(const std::string& text) { return 7 * static_cast<double>(text.size()); }

PlaneAxis axis(AxisRange range, double length) { return plane_axis("x", range, length, 60, width); }

TEST(PlaneAxes, BothEndsOfTheDomainHaveALabel) {
    const PlaneAxis made = axis({0, 1}, 400);
    ASSERT_GE(made.ticks.size(), 3U);
    EXPECT_EQ(made.ticks.front().value, 0);
    EXPECT_EQ(made.ticks.back().value, 1);
    EXPECT_EQ(made.ticks.front().label, "0");
}

TEST(PlaneAxes, NeitherLabelsNorTheNameTouch) {
    for (const AxisRange range :
         {AxisRange{0, 1}, {-1.6, 1.3}, {0.49981, 0.50023}, {-1e7, 3e7}, {2e-9, 7e-9}})
        for (double length = 20; length < 900; length *= 1.3) {
            const PlaneAxis made = axis(range, length);
            const auto at = [&](double value) { return (value - range.low) / range.span() * length; };
            double end = -1e9;
            bool named = made.name.empty();
            for (const Tick& tick : made.ticks) {
                if (tick.label.empty()) continue;
                if (!named && made.name_at < tick.value) {
                    EXPECT_GE(at(made.name_at) - width("x") / 2, end - 1e-6) << range.low << ' ' << length;
                    end = at(made.name_at) + width("x") / 2;
                    named = true;
                }
                EXPECT_GE(at(tick.value) - width(tick.label) / 2, end - 1e-6) << tick.label << ' ' << length;
                end = at(tick.value) + width(tick.label) / 2;
            }
        }
}

TEST(PlaneAxes, TheNameIsLeftOutWhereThereIsNoRoom) {
    EXPECT_EQ(axis({0, 1}, 400).name, "x");
    EXPECT_EQ(axis({0, 1}, 8).name, "");
    EXPECT_TRUE(axis({1, 1}, 400).ticks.empty());
    EXPECT_TRUE(axis({2, 1}, 400).ticks.empty()) << "nothing is seen";
}

TEST(PlaneAxes, WhatIsSeenEndsAtTheDomain) {
    EXPECT_EQ(seen_range(0, 1, -3, 7), (AxisRange{0, 1}));
    EXPECT_EQ(seen_range(0, 1, 0.25, 2), (AxisRange{0.25, 1}));
    const AxisRange nothing = seen_range(0, 1, 2, 3);
    EXPECT_GE(nothing.low, nothing.high);
}

TEST(PlaneAxes, RoundingDoesNotCostTheLabelsOfTheEnds) {
    const PlaneAxis made = axis({1e-4, 1 - 1e-4}, 400);
    EXPECT_EQ(made.ticks.front().value, 0);
    EXPECT_EQ(made.ticks.back().value, 1);
    EXPECT_GT(axis({0.01, 1}, 400).ticks.front().value, 0);
}

TEST(PlaneAxes, ThereAreTwoLabelsWhereTheyFit) {
    const PlaneAxis made = axis({0.51, 0.59}, 160);
    std::size_t labels = 0;
    for (const Tick& tick : made.ticks) labels += tick.label.empty() ? 0 : 1;
    EXPECT_GE(labels, 2U);
}

TEST(PlaneAxes, TheRoomForLabelsSeldomChanges) {
    const auto room = [](double low, double high) { return label_room({{0, low, 0}, {1, high, 0}}, width); };
    EXPECT_EQ(room(0, 1), room(0, 1.07));
    EXPECT_EQ(room(-1, 1), room(-1.04, 1.2));
    EXPECT_GE(room(-12345.6, -12345.5), width("−12345.60"));
    EXPECT_GT(room(0, 0), 0);
}

TEST(PlaneAxes, OnlyMeshesThatFillAPlaneHaveThem) {
    Mesh square = unit_square_mesh(2);
    EXPECT_TRUE(has_plane_axes(square));
    square.space_dimension = 3;
    EXPECT_FALSE(has_plane_axes(square));
    Mesh curve = unit_square_mesh(2);
    curve.kind = {CellShape::line, 1};
    EXPECT_FALSE(has_plane_axes(curve));
}

} // namespace
} // namespace gaspard
