// Monitors on domains of any size and place: the figure, scaled and moved.
#include "core/monitor/placement.hpp"
#include "support/built_in.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

constexpr double side = 2090;
constexpr Vec3 corner{5e5, 4e6, -30};

/// The space of a patch that is `side` times the unit square, or the square around the unit disk.
Space large_space(MonitorFigure figure) {
    const bool disk = figure == MonitorFigure::unit_disk;
    const Box box{corner, corner + side * Vec3{1, disk ? 1.0 : 0.5, 0}};
    return {.box = box, .middle = box.centre()};
}

/// Where a point of the figure lies in that space.
Vec3 in_space(MonitorFigure figure, Vec3 v) {
    if (figure == MonitorFigure::unit_disk) return corner + side / 2 * (v + Vec3{1, 1, 0});
    return corner + side * (v - Vec3{0, 0.25, 0}); // the box is half as high as the square
}

class Placement : public testing::TestWithParam<MonitorType> {
  protected:
    const MonitorType type = GetParam();
    const Space space = large_space(type.figure);
    std::mt19937 random{7};

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }

    void expect_scaled(const Values& small, const Values& large) {
        const auto figure = type.make(small, {});
        const auto monitor = make_on(type, large, {space});
        Points v(300), x(300), slope, slope_there;
        std::vector<double> expected(300), found(300);
        for (std::size_t i = 0; i < v.size(); ++i) {
            v.set(i, {uniform(-1, 1), uniform(-1, 1), 0});
            x.set(i, in_space(type.figure, v[i]));
        }
        figure->values(v, expected);
        monitor->values(x, found);
        figure->gradients(v, slope);
        monitor->gradients(x, slope_there);
        const double scale = type.figure == MonitorFigure::unit_disk ? side / 2 : side;
        for (std::size_t i = 0; i < v.size(); ++i) {
            // 4e6 has a resolution of 5e-10, of which the slope in the figure makes more
            const double loose = 1e-9 * (1 + norm(slope[i]));
            EXPECT_NEAR(found[i], expected[i], loose) << type.name;
            EXPECT_LT(norm(scale * slope_there[i] - slope[i]), 1e-5 * (1 + norm(slope[i]))) << type.name;
        }
    }
};

std::vector<MonitorType> placed_types() {
    std::vector<MonitorType> types;
    for (MonitorType& type : monitor_types())
        if (type.figure != MonitorFigure::none) types.push_back(std::move(type));
    return types;
}
INSTANTIATE_TEST_SUITE_P(All, Placement, testing::ValuesIn(placed_types()), [](const auto& type) {
    std::string name = type.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST_P(Placement, DefaultsAreTheScaledFigure) {
    expect_scaled(Values("monitor", type.rows({})), Values("monitor", rows_on(type, space)));
}

TEST_P(Placement, ValuesScaleWithTheDomain) {
    Values small("monitor", type.rows({})), large("monitor", rows_on(type, space));
    for (const ParameterRow& row : small.rows()) {
        if (row.kind != ParameterKind::real) continue;
        const double value = std::get<double>(row.default_value) * uniform(0.8, 1);
        small.set(row.key, value);
        const ParameterRow& there = *std::find_if(large.rows().begin(), large.rows().end(),
                                                  [&](const auto& one) { return one.key == row.key; });
        large.set(row.key, transferred(row, there, value));
        EXPECT_NEAR(transferred(there, row, large.real(row.key)), value, 1e-9 * std::abs(value)) << row.key;
    }
    expect_scaled(small, large);
}

TEST_P(Placement, CentresReachTheWholeBox) {
    for (const ParameterRow& row : rows_on(type, space)) {
        if (row.role != ParameterRole::x && row.role != ParameterRole::y) continue;
        const bool x = row.role == ParameterRole::x;
        EXPECT_LE(row.minimum, x ? space.box->low.x : space.box->low.y) << row.key;
        EXPECT_GE(row.maximum, x ? space.box->high.x : space.box->high.y) << row.key;
        EXPECT_LE(row.maximum - row.minimum, 20.1 * side) << "a slider over the domain, not over all numbers";
    }
}

TEST_P(Placement, WithoutABoxRowsAreThoseOfTheFigure) {
    for (const Space& plain : {Space{}, Space{SpaceKind::periodic_square}, Space{SpaceKind::sphere}}) {
        const auto expected = type.rows(plain), found = rows_on(type, plain);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].key, expected[i].key);
            EXPECT_EQ(found[i].minimum, expected[i].minimum);
            EXPECT_EQ(found[i].maximum, expected[i].maximum);
            EXPECT_EQ(found[i].default_value, expected[i].default_value);
        }
    }
}

TEST(PlacementOfLengths, IsThatOfTheirUnits) {
    const MonitorType ring = monitor_type("ring");
    const Values values("monitor", rows_on(ring, large_space(ring.figure)));
    EXPECT_EQ(values.real("radius"), 522.5);
    EXPECT_EQ(values.real("center_x"), 501045);
    EXPECT_EQ(values.real("center_y"), 4000522.5);
    EXPECT_EQ(values.real("amplitude"), 10);
    EXPECT_NEAR(values.real("sharpness"), 200 / (side * side), 1e-18);
    for (const ParameterRow& row : values.rows())
        if (row.key == "sharpness") {
            EXPECT_NEAR(row.minimum * side * side, 1, 1e-12);
            EXPECT_NEAR(row.maximum * side * side, 2000, 1e-9);
        }
}

TEST(PlacementInSpace, HasAThirdCoordinateForEveryCentre) {
    const Box box{{0, 0, 100}, {10, 10, 104}};
    const Space space{.dimension = 3, .box = box, .middle = {5, 5, 104}};
    for (const char* name : {"ring", "bell", "circle", "cosine-waves"}) {
        const MonitorType type = monitor_type(name);
        const Values values("monitor", rows_on(type, space));
        ASSERT_TRUE(values.has("center_z")) << name;
        EXPECT_EQ(values.real("center_z"), 104) << name << ": on the surface, not in the middle of the box";
        Points x(1);
        x.set(0, {5, 5, 104});
        std::vector<double> m(1);
        make_on(type, values, {space})->values(x, m);
        EXPECT_TRUE(std::isfinite(m[0]));
        if (type.name == "bell") {
            EXPECT_NEAR(m[0], 51, 1e-12);
        }
    }
}

} // namespace
} // namespace gaspard
