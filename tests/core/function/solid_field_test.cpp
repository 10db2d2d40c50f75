// Fields on solids: interpolation, placement, what lies beside the solid.
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/function/field_function.hpp"
#include "core/monitor/domain_grid.hpp"
#include "core/spline/solid_domain.hpp"
#include "core/spline/solid_shape.hpp"
#include "support/messages.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

using std::numbers::pi;

double wave(Vec3 x) { return std::sin(2 * x.x) * std::cos(x.y + 0.3) + x.z * x.z; }

DataContext in_space(const SolidDomain* solid = nullptr) {
    DataContext context;
    context.space = {.dimension = 3, .solid = true};
    context.discretisation = solid;
    return context;
}

/// A function on n^3 points from `low` to `high`.
template <class Function>
FieldData cube_of(std::size_t n, double low, double high, const Function& f) {
    GridData data{Coordinates::cartesian, {}, {}};
    for (auto& axis : data.axes)
        for (std::size_t i = 0; i < n; ++i)
            axis.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(n - 1));
    for (const double z : data.axes[2])
        for (const double y : data.axes[1])
            for (const double x : data.axes[0]) data.values.push_back(f(Vec3{x, y, z}));
    return {"u", {"u"}, std::move(data)};
}

FieldData points_of(std::size_t n, double low, double high, std::uint32_t seed = 5) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> at(low, high);
    ScatteredData data{Coordinates::cartesian, 3, Points(n), {}};
    for (std::size_t i = 0; i < n; ++i) {
        data.points.set(i, {at(random), at(random), at(random)});
        data.values.push_back(wave(data.points[i]));
    }
    return {"u", {"u"}, std::move(data)};
}

struct Errors {
    double value, gradient;
};

Errors errors_of(const ScalarFunction& u, double low, double high) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(low, high);
    Points x(300), gradients;
    for (std::size_t i = 0; i < x.size(); ++i) x.set(i, {at(random), at(random), at(random)});
    std::vector<double> values(x.size());
    u.values(x, values), u.gradients(x, gradients);
    Errors errors{0, 0};
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 p = x[i], exact{2 * std::cos(2 * p.x) * std::cos(p.y + 0.3),
                                   -std::sin(2 * p.x) * std::sin(p.y + 0.3), 2 * p.z};
        errors.value = std::max(errors.value, std::abs(values[i] - wave(p)));
        errors.gradient = std::max(errors.gradient, norm(gradients[i] - exact));
    }
    return errors;
}

TEST(SolidField, AGridIsInterpolatedWithOrderFour) {
    const auto coarse = field_function(cube_of(11, 0, 1, wave), {}, in_space());
    const auto fine = field_function(cube_of(21, 0, 1, wave), {}, in_space());
    EXPECT_TRUE(coarse.notes.empty()) << join(coarse.notes, " ");
    const Errors before = errors_of(*coarse.function, 0.2, 0.8), after = errors_of(*fine.function, 0.2, 0.8);
    EXPECT_LT(before.value, 2e-5);
    EXPECT_GT(before.value / after.value, 10);
    EXPECT_GT(before.gradient / after.gradient, 6);
}

TEST(SolidField, ScatteredPointsAreFitted) {
    const auto made = field_function(points_of(20000, 0, 1), {}, in_space());
    const Errors errors = errors_of(*made.function, 0.1, 0.9);
    EXPECT_LT(errors.value, 0.005);
    EXPECT_LT(errors.gradient, 0.5);
    EXPECT_EQ(made.notes.back(), "The field is a moving least-squares fit of 20000 points (linear, Gaussian "
                                 "weights, 12 neighbours).");
}

TEST(SolidField, DataWithOtherCoordinatesAreFittedToTheBoxOfTheSolid) {
    const SolidDomain ball(2, 4, ball_map());
    const auto made =
        field_function(cube_of(9, 100, 108, [](Vec3 x) { return x.x - 2 * x.z; }), {}, in_space(&ball));
    EXPECT_EQ(made.notes, std::vector<std::string>{"The data are fitted to the box of the domain."});
    Points x(1);
    std::vector<double> value(1);
    x.set(0, {0.5, -0.2, 0.25});
    made.function->values(x, value);
    EXPECT_NEAR(value[0], (104 + 4 * 0.5) - 2 * (104 + 4 * 0.25), 1e-9);
}

TEST(SolidField, CountsWhatTheDataDoNotCover) {
    const FieldData half = cube_of(9, 0, 0.5, wave);
    const FieldOptions placed{.placement = FieldPlacement::coordinates};
    const auto made = field_function(half, placed, in_space());
    ASSERT_EQ(made.notes.size(), 1u);
    EXPECT_TRUE(made.notes[0].starts_with("The data do not cover 8")) << made.notes[0]; // 7/8 of the cube
    const FieldOptions strict{.placement = FieldPlacement::coordinates, .missing = MissingValues::error};
    const std::string message = message_of<InputError>([&] { field_function(half, strict, in_space()); });
    EXPECT_NE(message.find("do not cover"), std::string::npos) << message;
}

TEST(SolidField, MissingValuesGoOnInAllDirections) {
    FieldData field = cube_of(
        7, 0, 1, [](Vec3 x) { return std::abs(x.z - 0.5) < 0.1 ? std::nan("") : (x.z > 0.5 ? 3.0 : 1.0); });
    const auto made = field_function(field, {}, in_space());
    Points x(2);
    std::vector<double> values(2);
    x.set(0, {0.5, 0.5, 0.1}), x.set(1, {0.5, 0.5, 0.9});
    made.function->values(x, values);
    EXPECT_NEAR(values[0], 1, 1e-5);
    EXPECT_NEAR(values[1], 3, 1e-5);
    EXPECT_TRUE(made.notes[0].starts_with("49 of 343 values are missing")) << made.notes[0];
}

TEST(SolidField, RefusesDataWithoutThreeDirections) {
    const FieldData flat{
        "rain", {"rain"}, GridData{Coordinates::cartesian, {{{0, 1}, {0, 1}, {}}}, {1, 2, 3, 4}}};
    EXPECT_EQ(message_of<InputError>([&] { field_function(flat, {}, in_space()); }),
              "'rain' has values in two directions only; a solid needs a field in x, y and z");
    FieldData plane = points_of(50, 0, 1);
    auto& data = std::get<ScatteredData>(plane.data);
    for (std::size_t i = 0; i < 50; ++i) data.points.z[i] = 1 + data.points.x[i] - 2 * data.points.y[i];
    const std::string message = message_of<InputError>([&] { field_function(plane, {}, in_space()); });
    EXPECT_TRUE(message.starts_with("all points of the field lie in a plane")) << message;
}

TEST(SolidShape, FindsTheNearestPointsOfTheBall) {
    const auto ball = solid_shape(ball_map());
    EXPECT_NEAR(ball->volume(), 4 * pi / 3, 0.01);
    EXPECT_FALSE(ball->is_box());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> at(-1.2, 1.2);
    Points x(3000), nearest;
    for (std::size_t i = 0; i < x.size(); ++i) x.set(i, {at(random), at(random), at(random)});
    ball->nearest(x, nearest);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double radius = norm(x[i]);
        const Vec3 expected = radius > 1 ? (1 / radius) * x[i] : x[i];
        // Towards the corners of the cube, where F is singular, searches end early.
        EXPECT_LT(norm(nearest[i] - expected), radius < 1.5 ? 1e-6 : 2e-3) << radius;
    }
}

TEST(SolidShape, KeepsThePointsOfEverySolid) {
    for (const auto& map : {half_torus_map(), cylinder_map(), cube_map()}) {
        const auto shape = solid_shape(map);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(0, 1);
        Points xi(2000), x, nearest;
        for (std::size_t i = 0; i < xi.size(); ++i) xi.set(i, {unit(random), unit(random), unit(random)});
        map->points(xi, x);
        shape->nearest(x, nearest);
        for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LT(norm(nearest[i] - x[i]), 1e-8);
    }
    EXPECT_TRUE(solid_shape(cube_map())->is_box());
    EXPECT_NEAR(solid_shape(half_torus_map())->volume(), 2 * pi * pi, 0.01 * pi * pi);
}

/// A pipe of radii 1 and 2, closed around its axis.
class Pipe final : public SolidMap {
  public:
    int space_dimension() const override { return 3; }
    void points(const Points& xi, Points& x) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            // Its ends are the same to the last bit, as those of splines may be.
            const double r = 1 + xi.x[i], t = 2 * pi * (xi.y[i] - std::floor(xi.y[i]));
            x.set(i, {r * std::cos(t), r * std::sin(t), xi.z[i]});
        }
    }
    void tangents(const Points& xi, std::array<Points, 3>& tangents) const override {
        for (Points& one : tangents) one.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const double r = 2 * pi * (1 + xi.x[i]), t = 2 * pi * xi.y[i];
            tangents[0].set(i, {std::cos(t), std::sin(t), 0});
            tangents[1].set(i, {-r * std::sin(t), r * std::cos(t), 0});
            tangents[2].set(i, {0, 0, 1});
        }
    }
    void places(const Points& xi, Points& x, std::span<double> element) const override {
        points(xi, x);
        for (std::size_t i = 0; i < xi.size(); ++i) element[i] = 2 * pi * (1 + xi.x[i]);
    }
    void element_gradients(const Points&, std::span<double>, Points&) const override {}
};

TEST(SolidShape, GoesOnAcrossTheSeamOfAPipe) {
    const auto pipe = solid_shape(std::make_shared<Pipe>());
    EXPECT_NEAR(pipe->volume(), 3 * pi, 1e-9);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> along(0.9, 2.1), angle(-0.12, 0.12), up(-0.1, 1.1);
    Points x(4000), nearest;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double r = along(random), t = angle(random);
        x.set(i, {r * std::cos(t), r * std::sin(t), up(random)});
    }
    pipe->nearest(x, nearest);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double r = std::hypot(x.x[i], x.y[i]), wanted = std::clamp(r, 1.0, 2.0) / r;
        EXPECT_LT(norm(nearest[i] - Vec3{wanted * x.x[i], wanted * x.y[i], std::clamp(x.z[i], 0.0, 1.0)}),
                  1e-7);
    }
}

TEST(SolidShape, TakesTheMeasureOfWhatLiesBesideTheSolid) {
    const SolidDomain ball(2, 8, ball_map());
    const DomainGrid domain = domain_grid(in_space(&ball), 6);
    EXPECT_TRUE(domain.patch);
    double volume = 0;
    for (std::size_t i = 0; i < domain.x.size(); ++i) {
        volume += domain.measures[i];
        EXPECT_LT(norm(domain.x[i]), 1 + 1e-6);
    }
    EXPECT_NEAR(volume, 4 * pi / 3, 0.02);
    EXPECT_NEAR(domain.cell, std::cbrt(4 * pi / 3) / 8, 1e-3);
    const SolidDomain cube(2, 8, cube_map());
    EXPECT_FALSE(domain_grid(in_space(&cube), 6).patch);
}

} // namespace
} // namespace gaspard
