#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/monitor/radial.hpp"
#include "support/built_in.hpp"
#include "support/monitor_values.hpp"
#include "support/sanitizers.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>
#include <string>

namespace gaspard {
namespace {

using Parameters = SechMonitor::Parameters;
const Space flat{SpaceKind::euclidean}, periodic{SpaceKind::periodic_square}, round{SpaceKind::sphere};

// The formula with the nearest of all images, slowly and in long double.
long double formula(const Parameters& p, Space space, long double x, long double y, long double z = 0) {
    long double nearest = std::numeric_limits<long double>::infinity();
    const int reach = space.kind == SpaceKind::periodic_square ? 4 : 0;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
            const long double dx = x - p.centre.x + i, dy = y - p.centre.y + j, dz = z - p.centre.z;
            nearest = std::min(nearest, dx * dx + dy * dy + dz * dz);
        }
    const long double c = std::cosh(p.sharpness * (nearest - p.radius_squared));
    return 1 + p.amplitude / (c * c);
}

const Parameters ring{10, 200, 0.0625, {0.5, 0.5, 0}}, bell{50, 100, 0, {0.5, 0.5, 0}},
    wide_ring{-0.9, 3, 0.2, {0.1, 0.95, 0}}, steep_bell{5000, 2000, 0, {0.8, 0.3, 0}};
const std::vector<Parameters> sech_cases = {ring, bell, wide_ring, steep_bell};

Points random_points(std::size_t count, double low, double high, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(low, high);
    Points points(count);
    for (std::size_t i = 0; i < count; ++i) points.set(i, {coordinate(random), coordinate(random), 0});
    return points;
}

TEST(SechMonitor, HasTheValuesOfItsFormula) {
    const Points x = random_points(2000, -1, 2, 1);
    for (const Space& space : {flat, periodic})
        for (const Parameters& p : sech_cases) {
            const auto values = values_of(SechMonitor(p, space), x);
            for (std::size_t i = 0; i < x.size(); ++i) {
                const auto expected = static_cast<double>(formula(p, space, x.x[i], x.y[i]));
                // The argument of sech^2 carries rounding of its own size times B.
                EXPECT_NEAR(values[i], expected, 1e-15 * (expected + 50 * std::abs(expected - 1)));
            }
        }
}

TEST(SechMonitor, MeansWhatThePaperPrints) {
    // (5.3) on the ring and at its centre; (5.4) at its centre and at half its height.
    Points x(2);
    x.set(0, {0.75, 0.5, 0});
    x.set(1, {0.5, 0.5, 0});
    const auto on_ring = values_of(SechMonitor(ring, periodic), x);
    EXPECT_EQ(on_ring[0], 11);
    EXPECT_NEAR(on_ring[1], 1 + 10 / std::pow(std::cosh(12.5), 2), 1e-15);
    x.set(0, {0.5, 0.5 + std::sqrt(std::acosh(std::sqrt(2.0)) / 100), 0});
    const auto on_bell = values_of(SechMonitor(bell, periodic), x);
    EXPECT_NEAR(on_bell[0], 26, 1e-12);
    EXPECT_EQ(on_bell[1], 51);
}

TEST(SechMonitor, HasTheGradientsOfItsDifferences) {
    const Points x = random_points(500, 0, 1, 2);
    for (const Space& space : {flat, periodic})
        for (const Parameters& p : sech_cases) {
            Points gradients;
            SechMonitor(p, space).gradients(x, gradients);
            ASSERT_EQ(gradients.size(), x.size());
            const double width = 1 / p.sharpness; // shorter than any feature
            for (std::size_t i = 0; i < x.size(); ++i) {
                const Vec3 d = displacement(space, p.centre, x[i]);
                if (std::max(std::abs(d.x), std::abs(d.y)) > 0.499) continue; // the torus' cut has a kink
                const long double h = 1e-3L * width;
                const auto difference = [&](long double ex, long double ey) { // of fourth order
                    const auto at = [&](int k) {
                        return formula(p, space, x.x[i] + k * h * ex, x.y[i] + k * h * ey);
                    };
                    return static_cast<double>((8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h));
                };
                const double tolerance = 1e-9 * std::abs(p.amplitude);
                EXPECT_NEAR(gradients.x[i], difference(1, 0), tolerance);
                EXPECT_NEAR(gradients.y[i], difference(0, 1), tolerance);
                EXPECT_EQ(gradients.z[i], 0);
            }
        }
}

TEST(SechMonitor, SeesTheDistanceInSpaceToo) {
    Points x(1), gradients;
    x.set(0, {0.6, 0.5, 0.2});
    const SechMonitor monitor(ring, flat);
    EXPECT_NEAR(values_of(monitor, x)[0], static_cast<double>(formula(ring, flat, 0.6L, 0.5L, 0.2L)), 1e-12);
    monitor.gradients(x, gradients);
    EXPECT_NEAR(gradients.z[0] / gradients.x[0], 2, 1e-12); // along x - c
}

TEST(SechMonitor, IsTheSameAtAllImagesOnTheTorus) {
    const Points x = random_points(300, 0, 1, 3);
    for (const Parameters& p : sech_cases) {
        const SechMonitor monitor(p, periodic);
        const auto here = values_of(monitor, x);
        Points gradients, elsewhere;
        monitor.gradients(x, gradients);
        for (const Vec3 period : {Vec3{1, 0, 0}, {0, -1, 0}, {-3, 2, 0}}) {
            Points moved(x.size());
            for (std::size_t i = 0; i < x.size(); ++i) moved.set(i, x[i] + period);
            const auto there = values_of(monitor, moved);
            monitor.gradients(moved, elsewhere);
            for (std::size_t i = 0; i < x.size(); ++i) {
                EXPECT_NEAR(there[i], here[i], 1e-11 * here[i]);
                EXPECT_NEAR(norm(elsewhere[i] - gradients[i]), 0, 1e-9 * std::abs(p.amplitude));
            }
        }
        Points sides(2);
        sides.set(0, {0, 0.3, 0});
        sides.set(1, {1, 0.3, 0});
        EXPECT_NEAR(values_of(monitor, sides)[0], values_of(monitor, sides)[1], 1e-11);
    }
}

TEST(SechMonitor, IsOneFarAwayAndNeverNotANumber) {
    Points x(4), gradients;
    const double distances[] = {10, 1e4, 1e100, 1e200};
    for (std::size_t i = 0; i < 4; ++i) x.set(i, {distances[i], -distances[i], 0});
    for (const Parameters& p : sech_cases) {
        const SechMonitor monitor(p, flat);
        for (const double value : values_of(monitor, x)) EXPECT_EQ(value, 1);
        monitor.gradients(x, gradients);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(norm(gradients[i]), 0);
        for (const double value : values_of(SechMonitor(p, periodic), x)) EXPECT_TRUE(std::isfinite(value));
    }
}

std::string complaint(const Monitor& monitor) {
    try {
        monitor.check();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SechMonitor, SaysWhichParameterMakesItNegative) {
    const auto with_amplitude = [](double amplitude) {
        Parameters p = ring;
        p.amplitude = amplitude;
        return complaint(SechMonitor(p, flat));
    };
    EXPECT_EQ(with_amplitude(-0.99), "");
    EXPECT_EQ(with_amplitude(0), "");
    for (const double amplitude : {-1.0, -1.5, -1e300}) {
        EXPECT_NE(with_amplitude(amplitude).find("monitor.amplitude = " + exact_number(amplitude)),
                  std::string::npos);
        EXPECT_NE(with_amplitude(amplitude).find("greater than −1"), std::string::npos);
    }
}

TEST(SechMonitor, RefusesParametersThatAreNotFinite) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        Parameters p = ring;
        p.amplitude = bad;
        EXPECT_NE(complaint(SechMonitor(p, flat)).find("must be finite"), std::string::npos) << bad;
    }
}

TEST(Monitors, RefuseRoomOfTheWrongSize) {
    std::vector<double> values(3);
    EXPECT_THROW(SechMonitor(ring, flat).values(Points(2), values), InternalError);
    EXPECT_THROW(make_monitor("constant", flat)->values(Points(2), values), InternalError);
}

// Every parameter within its row's range: the ends, the default, and in between as the slider runs.
void randomise(Values& values, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    for (const ParameterRow& row : values.rows()) {
        if (row.kind == ParameterKind::boolean) {
            values.set(row.key, unit(random) < 0.5);
            continue;
        }
        if (row.kind != ParameterKind::real && row.kind != ParameterKind::integer) continue;
        const double pick = unit(random), u = unit(random);
        const auto [least, largest] = row.slider.value_or(SliderRange{row.minimum, row.maximum});
        double value = row.scale == ParameterScale::logarithmic && least > 0
                           ? least * std::pow(largest / least, u)
                           : least + u * (largest - least);
        value = std::clamp(value, least, largest);
        value = pick < 0.1 ? least : pick > 0.9 ? largest : value;
        if (row.kind == ParameterKind::integer)
            values.set(row.key, static_cast<std::int64_t>(value));
        else
            values.set(row.key, value);
    }
}

TEST(Monitors, ArePositiveForAllParametersInRange) {
    std::mt19937 random(4);
    const Points x = random_points(200, -1, 2, 5);
    ASSERT_EQ(monitor_types().size(), 24u);
    // Those that are sampled and smoothed, or computed.
    const std::set<std::string> slow = {"image", "derived", "combine", "flow", "burgers"};
    for (const MonitorType& type : monitor_types())
        for (int trial = 0; trial < (slow.count(type.name) == 1 ? sanitized ? 1 : 4 : 200); ++trial)
            for (const Space& space : {flat, periodic, round}) {
                Values values = default_values(type, space);
                randomise(values, random);
                if (type.name == "field" || !type.make) continue; // a file of values; a tensor monitor
                for (const auto& [key, few] : {std::pair{"cells", 50}, {"t", 0}}) // of what is computed
                    if (slow.contains(type.name) && values.has(key))
                        values.set(key, std::int64_t{few});
                for (const char* key : {"eps", "eps1", "eps2"})   // of a problem, where they are automatic
                    if (values.has(key) && !values.real_or_auto(key)) values.set(key, 1e-3);
                if (type.name == "image") values.set("file", std::string("gaspard:portrait.png"));
                const auto monitor = type.make(values, {space});
                EXPECT_EQ(complaint(*monitor), "");
                for (const double value : values_of(*monitor, x)) {
                    ASSERT_TRUE(std::isfinite(value)) << type.name;
                    ASSERT_GT(value, 0) << type.name;
                }
                Points gradients;
                monitor->gradients(x, gradients);
                for (std::size_t i = 0; i < x.size(); ++i)
                    ASSERT_TRUE(std::isfinite(norm(gradients[i]))) << type.name;
            }
}

TEST(Monitors, TakeTheirParametersFromTheirRows) {
    const Points x = random_points(100, 0, 1, 6);
    const auto expect_same = [&](const std::string& name, const Settings& settings, const Parameters& p) {
        EXPECT_EQ(values_of(*make_monitor(name, periodic, settings), x),
                  values_of(SechMonitor(p, periodic), x));
    };
    expect_same("ring", {}, ring);
    expect_same("bell", {}, bell);
    expect_same(
        "ring",
        {{"amplitude", 3}, {"sharpness", 20}, {"radius", 0.5}, {"center_x", 0.125}, {"center_y", 0.75}},
        {3, 20, 0.25, {0.125, 0.75, 0}});
    expect_same("bell", {{"amplitude", 3}, {"sharpness", 20}, {"center_x", 0.125}, {"center_y", 0.75}},
                {3, 20, 0, {0.125, 0.75, 0}});
    const auto constant = make_monitor("constant", flat, {{"value", 2.5}});
    EXPECT_EQ(values_of(*constant, x), std::vector<double>(100, 2.5));
    Points gradients(1);
    constant->gradients(x, gradients);
    EXPECT_EQ(gradients, Points(100));
}

TEST(Monitors, AreHalfAsHighWhereTheirHelpSays) {
    const auto height = [](const Parameters& p, double distance) {
        Points x(1);
        x.set(0, p.centre + Vec3{distance, 0, 0});
        return (values_of(SechMonitor(p, flat), x)[0] - 1) / p.amplitude;
    };
    EXPECT_NEAR(height(bell, 0.94 / std::sqrt(100.0)), 0.5, 0.01);
    EXPECT_NEAR(height(ring, 0.25 + 0.44 / (200 * 0.25)), 0.5, 0.03);
    EXPECT_NEAR(height(ring, 0.25 - 0.44 / (200 * 0.25)), 0.5, 0.03);
}

} // namespace
} // namespace gaspard
