#include "core/base/stopwatch.hpp"
#include "gui/plot/plot_curves.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace gaspard {
namespace {

TEST(PlotTime, OfAMillionPointsIsThatOfTheirPixels) {
    std::vector<double> x, y;
    Extremes extremes;
    for (int i = 0; i < 1000000; ++i) {
        x.push_back(i), y.push_back(2 + std::sin(0.01 * i));
        extremes.append(y.back());
    }
    const CurveView curve{.label = "run", .part = {}, .x = x, .y = y, .extremes = &extremes};
    PlotFrame frame;
    frame.y.logarithmic = true;
    frame.x_range = {0, 999999}, frame.y_range = {-1, 1};
    frame.area = {{100, 100}, {500, 300}};
    const Stopwatch watch;
    for (int repeated = 0; repeated < 100; ++repeated) ASSERT_GT(pixel_path(curve, frame).x.size(), 400U);
    EXPECT_LT(watch.cpu_seconds(), 0.5) << "5 ms each; a search through all of them takes 20";
}

} // namespace
} // namespace gaspard
