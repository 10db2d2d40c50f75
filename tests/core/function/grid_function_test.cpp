#include "core/function/grid_function.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

using std::numbers::pi;

std::vector<double> sampled(const Grid& grid, const auto& f) {
    Points x;
    grid.chart->points(grid.coordinates(), x);
    std::vector<double> values(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) values[i] = f(x[i]);
    return values;
}

Points random_points(std::size_t n, Vec3 low, Vec3 high) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    Points x(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 u{unit(random), unit(random), unit(random)};
        x.set(i, {low.x + u.x * (high.x - low.x), low.y + u.y * (high.y - low.y),
                  low.z + u.z * (high.z - low.z)});
    }
    return x;
}

/// Largest errors of values and gradients.
std::pair<double, double> errors(const GridFunction& u, const Points& x, const auto& f,
                                 const auto& gradient) {
    std::vector<double> values(x.size());
    u.values(x, values);
    Points g;
    u.gradients(x, g);
    std::pair<double, double> error{0, 0};
    for (std::size_t i = 0; i < x.size(); ++i) {
        error.first = std::max(error.first, std::abs(values[i] - f(x[i])));
        error.second = std::max(error.second, norm(g[i] - gradient(x[i])));
    }
    return error;
}

/// The orders to which values and gradients converge when the number of points is doubled.
void expect_orders(const std::function<Grid(std::size_t)>& grid, const Points& x, const auto& f,
                   const auto& gradient, std::size_t coarse = 32) {
    std::vector<std::pair<double, double>> e;
    for (const std::size_t n : {coarse, 2 * coarse}) {
        const Grid on = grid(n);
        e.push_back(errors(GridFunction(on, sampled(on, f)), x, f, gradient));
    }
    EXPECT_GT(std::log2(e[0].first / e[1].first), 3.7) << e[0].first << " " << e[1].first;
    EXPECT_GT(std::log2(e[0].second / e[1].second), 2.8) << e[0].second << " " << e[1].second;
    EXPECT_LT(e[1].first, 1e-3);
}

const Box unit{{0, 0, 0}, {1, 1, 1}};

TEST(GridFunction, HasOrderFourOnThePeriodicSquare) {
    const auto f = [](Vec3 x) { return std::exp(std::sin(2 * pi * x.x) * std::cos(2 * pi * x.y)); };
    const auto g = [&](Vec3 x) {
        const double sx = std::sin(2 * pi * x.x), cx = std::cos(2 * pi * x.x), sy = std::sin(2 * pi * x.y),
                     cy = std::cos(2 * pi * x.y);
        return 2 * pi * f(x) * Vec3{cx * cy, -sx * sy, 0};
    };
    const auto chart = box_chart(unit, 2, ChartEnds::periodic);
    // Other images of the square, too.
    expect_orders(
        [&](std::size_t n) {
            return grid_on(chart, {n, n + n / 4});
        },
        random_points(500, {-2, -1, 0}, {3, 2, 0}), f, g);
}

TEST(GridFunction, HasOrderFourUpToFreeEnds) {
    const auto f = [](Vec3 x) { return std::exp(x.x + 0.5 * x.y) + std::sin(3 * x.y); };
    const auto g = [](Vec3 x) {
        const double e = std::exp(x.x + 0.5 * x.y);
        return Vec3{e, 0.5 * e + 3 * std::cos(3 * x.y), 0};
    };
    const auto chart = box_chart({{-1, 2, 0}, {3, 3, 0}}, 2, ChartEnds::open);
    expect_orders(
        [&](std::size_t n) {
            return grid_on(chart, {n + 1, n + 1});
        },
        random_points(500, {-1, 2, 0}, {3, 3, 0}), f, g);
}

TEST(GridFunction, HasOrderFourWithReflectingEnds) {
    const auto f = [](Vec3 x) { return std::cos(pi * x.x) * std::exp(std::cos(2 * pi * x.y)); };
    const auto g = [](Vec3 x) {
        const double e = std::exp(std::cos(2 * pi * x.y));
        return Vec3{-pi * std::sin(pi * x.x) * e, -2 * pi * std::sin(2 * pi * x.y) * std::cos(pi * x.x) * e,
                    0};
    };
    const auto chart = box_chart(unit, 2, ChartEnds::open);
    expect_orders(
        [&](std::size_t n) {
            return grid_on(chart, {n, n}, GridEnds::reflecting);
        },
        random_points(500, {-1.5, -0.5, 0}, {2.5, 1.5, 0}), f, g);
    expect_orders(
        [&](std::size_t n) {
            Grid grid = grid_on(chart, {n + 1, n + 1}, GridEnds::reflecting);
            for (GridDirection& direction : grid.directions) direction.centred = false;
            return grid;
        },
        random_points(500, {-0.5, -0.5, 0}, {1.5, 1.5, 0}), f, g);
}

TEST(GridFunction, HasOrderFourInOneAndThreeDirections) {
    const auto line = box_chart({{0, 0, 0}, {2, 0, 0}}, 1, ChartEnds::open);
    const auto f1 = [](Vec3 x) { return std::sin(4 * x.x); };
    const auto g1 = [](Vec3 x) { return Vec3{4 * std::cos(4 * x.x), 0, 0}; };
    expect_orders([&](std::size_t n) { return grid_on(line, {n + 1}); },
                  random_points(200, {0, 0, 0}, {2, 0, 0}), f1, g1);
    const auto cube = box_chart(unit, 3, ChartEnds::open);
    const auto f3 = [](Vec3 x) { return std::sin(x.x + 2 * x.y) * std::exp(x.z); };
    const auto g3 = [](Vec3 x) {
        const double c = std::cos(x.x + 2 * x.y), s = std::sin(x.x + 2 * x.y);
        return std::exp(x.z) * Vec3{c, 2 * c, s};
    };
    expect_orders(
        [&](std::size_t n) {
            return grid_on(cube, {n + 1, n + 1, n + 1});
        },
        random_points(300, {0, 0, 0}, {1, 1, 1}), f3, g3, 8);
}

/// A smooth function whose pole is turned to a general place: nothing about it is special at the poles.
TEST(GridFunction, IsSmoothAcrossThePoles) {
    const double radius = 2.5;
    const Vec3 to = at_latitude_longitude(70, 33);
    const auto f = [&](Vec3 x) {
        const Vec3 e = (1 / norm(x)) * x;
        return std::exp(2 * dot(e, to)) + e.x * e.y * e.z;
    };
    const auto g = [&](Vec3 x) {
        const Vec3 e = (1 / norm(x)) * x;
        const Vec3 full =
            (1 / radius) * (2 * std::exp(2 * dot(e, to)) * to + Vec3{e.y * e.z, e.x * e.z, e.x * e.y});
        return full - dot(full, e) * e;
    };
    const auto chart = sphere_chart(radius);
    Points x = random_points(400, {-1, -1, -1}, {1, 1, 1});
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i < 200) x.x[i] *= 1e-2, x.y[i] *= 1e-2; // near the poles
        if (i < 100) x.x[i] *= 1e-5, x.y[i] *= 1e-5;
        if (i < 2) x.set(i, {0, 0, i == 0 ? 1.0 : -1.0});
        x.set(i, (radius / norm(x[i])) * x[i]);
    }
    expect_orders([&](std::size_t n) { return grid_on(chart, {2 * n, n + 1}); }, x, f, g);
    const Grid grid = grid_on(chart, {128, 65});
    const GridFunction u(grid, sampled(grid, f));
    std::vector<double> values(x.size());
    u.values(x, values);
    EXPECT_NEAR(values[0], f({0, 0, radius}), 1e-12); // a point of the grid
    EXPECT_LT(errors(u, x, f, g).second, 2e-4);
}

TEST(GridFunction, ReproducesConstantsAndLinesAndGoesOnLinearly) {
    const auto chart = box_chart({{0, -1, 0}, {2, 1, 0}}, 2, ChartEnds::open);
    const auto f = [](Vec3 x) { return 3 - 2 * x.x + 0.25 * x.y; };
    const auto g = [](Vec3) { return Vec3{-2, 0.25, 0}; };
    const Points x = random_points(200, {-1, -2, 0}, {3, 2, 0}); // beside the box, too
    for (const std::size_t n : {2, 3, 4, 5, 6, 50}) {
        const Grid grid = grid_on(chart, {n, n + 1});
        const auto e = errors(GridFunction(grid, sampled(grid, f)), x, f, g);
        EXPECT_LT(e.first, 1e-10) << n;
        EXPECT_LT(e.second, 1e-10) << n;
    }
    const auto one = [](Vec3) { return 7.0; };
    const auto zero = [](Vec3) { return Vec3{}; };
    for (const std::size_t n : {1, 2, 3, 17})
        for (const auto& [at, ends] : {std::pair{chart, GridEnds::free},
                                       {chart, GridEnds::reflecting},
                                       {box_chart(unit, 2, ChartEnds::periodic), GridEnds::free},
                                       {sphere_chart(1), GridEnds::free}}) {
            const Grid grid = grid_on(at, {n, n}, ends);
            const auto e = errors(GridFunction(grid, sampled(grid, one)), x, one, zero);
            EXPECT_LT(e.first, 1e-10) << n;
            EXPECT_LT(e.second, 1e-10) << n;
        }
}

TEST(GridFunction, InterpolatesItsValuesAndIsTwiceContinuouslyDifferentiable) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    const auto chart = box_chart(unit, 2, ChartEnds::open);
    for (const GridEnds ends : {GridEnds::free, GridEnds::reflecting}) {
        const Grid grid = grid_on(chart, {9, 7}, ends);
        std::vector<double> data(grid.size()), values(grid.size());
        for (double& value : data) value = normal(random);
        const GridFunction u(grid, data);
        u.values(grid.coordinates(), values);
        for (std::size_t i = 0; i < data.size(); ++i) EXPECT_NEAR(values[i], data[i], 1e-12);
        // Second differences of the gradient on both sides of a knot agree.
        const double knot = grid.coordinate(0, 4), step = 1e-4;
        Points x(3), g;
        for (std::size_t i = 0; i < 3; ++i) x.set(i, {knot + (static_cast<double>(i) - 1) * step, 0.4, 0});
        u.gradients(x, g);
        const double bend_before = (g.x[1] - g.x[0]) / step, bend_after = (g.x[2] - g.x[1]) / step;
        EXPECT_NEAR(bend_before, bend_after, 0.3 + 1e-2 * std::abs(bend_after));
    }
}

TEST(GridFunction, HasTheGradientsOfItsValues) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (const auto& chart : {box_chart(unit, 2, ChartEnds::periodic), sphere_chart(1)}) {
        const Grid grid = grid_on(chart, {24, 13});
        std::vector<double> data(grid.size());
        for (double& value : data) value = normal(random);
        const GridFunction u(grid, data);
        Points x = random_points(50, {-1, -1, -1}, {1, 1, 1}), g;
        const bool sphere = chart->kind() == ChartKind::sphere;
        for (std::size_t i = 0; sphere && i < x.size(); ++i) x.set(i, (1 / norm(x[i])) * x[i]);
        u.gradients(x, g);
        const double h = 1e-6;
        for (std::size_t i = 0; i < x.size(); ++i)
            for (const Vec3 along : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
                Points two(2);
                two.set(0, x[i] - h * along), two.set(1, x[i] + h * along);
                std::vector<double> v(2);
                u.values(two, v);
                // On the sphere the function goes on constantly along the radius.
                EXPECT_NEAR((v[1] - v[0]) / (2 * h), dot(g[i], along), 1e-6 * std::max(1.0, norm(g[i])));
            }
    }
}

TEST(GridFunction, IsNanWhereACoordinateIsNotFinite) {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
    for (const ChartEnds ends : {ChartEnds::periodic, ChartEnds::open})
        for (const GridEnds open_ends : {GridEnds::free, GridEnds::reflecting}) {
            const Grid grid = grid_on(box_chart(unit, 2, ends), {8, 8}, open_ends);
            const GridFunction u(grid, std::vector<double>(grid.size(), 3));
            Points x(5), g;
            x.set(0, {nan, 0.5, 0}), x.set(1, {0.5, nan, 0}), x.set(2, {infinity, 0.5, 0});
            x.set(3, {0.5, -infinity, 0}), x.set(4, {0.5, 0.5, 0});
            std::vector<double> values(5);
            u.values(x, values);
            u.gradients(x, g);
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_TRUE(std::isnan(values[i])) << i;
                EXPECT_TRUE(std::isnan(g.x[i]) && std::isnan(g.y[i])) << i;
            }
            EXPECT_NEAR(values[4], 3, 1e-12);
        }
}

} // namespace
} // namespace gaspard
