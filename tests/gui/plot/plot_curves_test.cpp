#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A long column with its extremes.
struct Column {
    std::vector<double> x, y;
    Extremes extremes;
    void add(double at, double value) {
        x.push_back(at), y.push_back(value);
        extremes.append(value);
    }
    CurveView view() const { return {.label = "run", .part = {}, .x = x, .y = y, .extremes = &extremes}; }
};

PlotFrame frame_of(AxisRange x, AxisRange y, bool logarithmic = false) {
    PlotFrame frame;
    frame.y.logarithmic = logarithmic;
    frame.x_range = x, frame.y_range = y;
    frame.area = {{100, 100}, {500, 300}};
    return frame;
}

/// Lowest and highest pixel within a stretch of the screen.
std::pair<double, double> hull(const PixelPath& path, double left, double right) {
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < path.x.size(); ++i)
        if (path.x[i] >= left && path.x[i] <= right && !std::isnan(path.y[i]))
            low = std::min(low, path.y[i]), high = std::max(high, path.y[i]);
    return {low, high};
}

TEST(PixelPath, OfALongCurveKeepsEveryPeakWithinItsPixel) {
    Column column;
    for (int i = 0; i < 100000; ++i)
        column.add(i, i == 31234 ? 7 : i == 71234 ? -9 : std::sin(0.37 * i) + 0.3 * std::sin(1e-4 * i));
    const PlotFrame frame = frame_of({0, 99999}, {-10, 10});
    const PixelPath path = pixel_path(column.view(), frame);
    EXPECT_LT(path.x.size(), 5U * 400) << "as many points as pixels, not as values";
    const double up = frame.pixel_x(31234), down = frame.pixel_x(71234);
    EXPECT_NEAR(hull(path, up - 1.5, up + 1.5).first, frame.pixel_y(7), 1e-9);
    EXPECT_NEAR(hull(path, down - 1.5, down + 1.5).second, frame.pixel_y(-9), 1e-9);
    EXPECT_TRUE(std::is_sorted(path.x.begin(), path.x.end()));
    for (double left = 100; left < 500; left += 10) { // against all points, ten pixels at a time
        double low = 1e300, high = -1e300;
        for (std::size_t i = 0; i < column.x.size(); ++i) {
            const double x = frame.pixel_x(column.x[i]);
            if (x < left || x > left + 10) continue;
            low = std::min(low, frame.pixel_y(column.y[i])),
            high = std::max(high, frame.pixel_y(column.y[i]));
        }
        const auto inner = hull(path, left - 1, left + 11);
        EXPECT_LE(inner.first, low + 1e-9) << left;
        EXPECT_GE(inner.second, high - 1e-9) << left;
    }
}

TEST(PixelPath, OfAFewPointsIsAllOfThem) {
    Column column;
    for (int i = 0; i < 50; ++i) column.add(i, i == 20 ? missing : i);
    const PlotFrame frame = frame_of({0, 49}, {0, 49});
    const PixelPath path = pixel_path(column.view(), frame);
    ASSERT_EQ(path.x.size(), 50U);
    EXPECT_TRUE(std::isnan(path.y[20])) << "a gap";
    EXPECT_EQ(path.y[7], frame.pixel_y(7));
}

TEST(PixelPath, OfAZoomedCurveReachesJustBeyondTheArea) {
    Column column;
    for (int i = 0; i < 100000; ++i) column.add(i, 1 + i % 3);
    const PixelPath path = pixel_path(column.view(), frame_of({5000.5, 5010.5}, {0, 5}));
    ASSERT_EQ(path.x.size(), 12U) << "ten inside, and one more at either side";
    EXPECT_LT(path.x.front(), 100);
    EXPECT_GT(path.x.back(), 500);
    EXPECT_EQ(pixel_path(column.view(), frame_of({-50, -40}, {0, 5})).x.size(), 1U);
    EXPECT_EQ(pixel_path(column.view(), frame_of({200000, 200010}, {0, 5})).x.size(), 1U);
}

TEST(PixelPath, OnALogarithmicAxisHasGapsWhereNothingIsPositive) {
    Column column;
    for (int i = 0; i < 100000; ++i) column.add(i, i < 40000 || i > 60000 ? 1e-3 : i % 2 == 0 ? 0 : -1);
    const PlotFrame frame = frame_of({0, 99999}, {-4, 0}, true);
    const PixelPath path = pixel_path(column.view(), frame);
    EXPECT_TRUE(std::any_of(path.y.begin(), path.y.end(), [](double y) { return std::isnan(y); }));
    for (std::size_t i = 0; i < path.x.size(); ++i) { // but for the pixels where they begin and end
        const double from_middle = std::abs(path.x[i] - frame.pixel_x(50000)) / 400;
        EXPECT_TRUE(std::isnan(path.y[i]) || from_middle > 0.094) << path.x[i];
        EXPECT_TRUE(!std::isnan(path.y[i]) || from_middle < 0.106) << path.x[i];
    }
}

} // namespace
} // namespace gaspard
