#include "core/base/error.hpp"
#include "support/built_in.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

constexpr double pi = std::numbers::pi;
const Space globe{SpaceKind::sphere};

double value_at(const Monitor& monitor, Vec3 p) {
    Points x(1);
    x.set(0, p);
    double value = 0;
    monitor.values(x, {&value, 1});
    return value;
}
Vec3 gradient_at(const Monitor& monitor, Vec3 p) {
    Points x(1), gradient;
    x.set(0, p);
    monitor.gradients(x, gradient);
    return gradient[0];
}

struct Case {
    std::string type;
    Settings settings;
};
const std::vector<Case> cases = {
    {"ring", {}},
    {"ring", {{"radius", 2}, {"sharpness", 3}, {"center_latitude", -70}, {"center_longitude", 200}}},
    {"bell", {{"center_latitude", 90}}},
    {"x-n", {}},
    {"x-n", {{"ratio", 32}, {"alpha", 0.05}, {"beta", 1}, {"center_longitude", -120}}},
    {"cross", {}},
    {"cross", {{"amplitude", 100}, {"pole1_latitude", -90}, {"pole2_longitude", 33}}},
    {"constant", {}}};

TEST(GeodesicMonitors, HaveTheValuesOfTheirFormulas) {
    std::mt19937 random(1);
    std::normal_distribution<double> coordinate;
    const Vec3 centre = at_latitude_longitude(30, 0);
    const double root = std::sqrt(3.0) / 2;
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 p{coordinate(random), coordinate(random), coordinate(random)}; // of any length
        const double d = std::acos(dot(p, centre) / norm(p));
        const auto sech2 = [](double t) { return 1 / (std::cosh(t) * std::cosh(t)); };
        EXPECT_NEAR(value_at(*make_monitor("ring", globe, {{"sharpness", 7}, {"radius", 0.6}}), p),
                    1 + 10 * sech2(7 * (d * d - 0.36)), 1e-11);
        EXPECT_NEAR(value_at(*make_monitor("bell", globe), p), 1 + 20 * sech2(10 * d * d), 1e-11);
        const double gamma = std::pow(0.25, 4);
        EXPECT_NEAR(value_at(*make_monitor("x-n", globe, {{"ratio", 4}}), p),
                    std::sqrt((1 - gamma) / 2 * (std::tanh((pi / 6 - d) / (pi / 20)) + 1) + gamma), 1e-12);
        double bands = 1;
        for (const double side : {root, -root}) {
            const double to_pole = std::acos(dot(p, {side, 0, 0.5}) / norm(p));
            bands += 10 * sech2(5 * (to_pole * to_pole - pi * pi / 4));
        }
        EXPECT_NEAR(value_at(*make_monitor("cross", globe), p), bands, 1e-11);
    }
}

TEST(GeodesicMonitors, XnFallsFromOneToTheRootOfGamma) {
    const auto monitor = make_monitor("x-n", globe, {{"ratio", 16}, {"alpha", 0.01}});
    EXPECT_NEAR(value_at(*monitor, at_latitude_longitude(30, 0)), 1, 1e-15);
    EXPECT_NEAR(value_at(*monitor, at_latitude_longitude(-30, 180)), 1.0 / 256, 1e-15);
}

TEST(GeodesicMonitors, HaveTheTangentialGradientsOfTheirDifferences) {
    std::mt19937 random(2);
    std::normal_distribution<double> coordinate;
    for (const auto& [type, settings] : cases) {
        SCOPED_TRACE(type);
        const auto monitor = make_monitor(type, globe, settings);
        for (const double radius : {1.0, 6371e3})
            for (int trial = 0; trial < 200; ++trial) {
                Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
                p = (radius / norm(p)) * p;
                const Vec3 gradient = gradient_at(*monitor, p);
                EXPECT_NEAR(radius * dot(gradient, (1 / radius) * p), 0, 1e-10);
                const double h =
                    1e-4 * radius; // of fourth order, through space: values depend on direction alone
                const auto difference = [&](Vec3 e) {
                    const auto at = [&](int k) { return value_at(*monitor, p + (k * h) * e); };
                    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
                };
                const double tolerance = 1e-6 / radius;
                EXPECT_NEAR(gradient.x, difference({1, 0, 0}), tolerance);
                EXPECT_NEAR(gradient.y, difference({0, 1, 0}), tolerance);
                EXPECT_NEAR(gradient.z, difference({0, 0, 1}), tolerance);
            }
    }
}

TEST(GeodesicMonitors, AreUnharmedAtCentresAndOppositeToThem) {
    for (const auto& [type, settings] : cases) {
        SCOPED_TRACE(type);
        const auto monitor = make_monitor(type, globe, settings);
        std::vector<Vec3> places = {{0, 0, 1}, {0, 0, -1}};
        if (const auto axis = monitor->symmetry_axis()) places.insert(places.end(), {*axis, -1.0 * *axis});
        for (const Vec3 place : places) {
            const double here = value_at(*monitor, place);
            EXPECT_TRUE(std::isfinite(here) && here > 0);
            EXPECT_TRUE(std::isfinite(norm(gradient_at(*monitor, place))));
            EXPECT_NEAR(value_at(*monitor, place + Vec3{1e-9, -1e-9, 1e-9}), here, 1e-6);
        }
    }
}

TEST(GeodesicMonitors, DoNotChangeWhenTheyTurnAroundTheirAxis) {
    for (const auto& [type, settings] : cases) {
        const auto monitor = make_monitor(type, globe, settings);
        const auto axis = monitor->symmetry_axis();
        EXPECT_EQ(axis.has_value(), type != "cross");
        if (!axis) continue;
        const Vec3 a = cross(*axis, {0.3, -0.5, 0.7}), across = (1 / norm(a)) * a,
                   other = cross(*axis, across);
        for (const double s : {0.3, 1.0, 2.5}) {
            const auto at = [&](double turn) {
                return std::cos(s) * *axis + std::sin(s) * (std::cos(turn) * across + std::sin(turn) * other);
            };
            for (const double turn : {1.0, 2.0, 4.0})
                EXPECT_NEAR(value_at(*monitor, at(turn)), value_at(*monitor, at(0)), 1e-12);
        }
    }
}

TEST(GeodesicMonitors, RefuseAnAmplitudeThatMakesThemVanish) {
    const auto type = monitor_type("cross");
    Values values("monitor", type.rows(globe));
    EXPECT_THROW(values.set("amplitude", -0.5), InputError);
    EXPECT_NO_THROW(values.set("amplitude", -0.49));
    EXPECT_NO_THROW(type.make(values, {globe})->check());
}

} // namespace
} // namespace gaspard
