#include "core/base/error.hpp"
#include "core/function/smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <random>

namespace gaspard {
namespace {

using std::numbers::pi;
const Box box{{-1, 0, 0}, {2, 2, 0}};

std::vector<double> sampled(const Grid& grid, const std::function<double(Vec3)>& f) {
    Points x;
    grid.chart->points(grid.coordinates(), x);
    std::vector<double> values(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) values[i] = f(x[i]);
    return values;
}

std::vector<double> noise(std::size_t n) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> values(n);
    for (double& value : values) value = unit(random);
    return values;
}

double mean(const Grid& grid, const std::vector<double>& values) {
    const std::vector<double> weights = measures(grid);
    return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) /
           std::accumulate(weights.begin(), weights.end(), 0.0);
}

/// Half a torus of radii 2 and 1 with oblique parameters, so that the metric has all its entries.
class TorusChart final : public Chart {
  public:
    explicit TorusChart(bool closed)
        : Chart(ChartKind::surface,
                {{"u", 0, 1, ChartEnds::open}, {"v", 0, 1, closed ? ChartEnds::periodic : ChartEnds::open}}) {
    }
    void coordinates(const Points&, Points&) const override { FAIL(); }
    void points(const Points& s, Points& x) const override {
        x.resize(s.size());
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double a = pi * s.x[i], b = angle(s.x[i], s.y[i]), r = 2 + std::cos(b);
            x.set(i, {r * std::cos(a), r * std::sin(a), std::sin(b)});
        }
    }
    void tangents(const Points& s, std::array<Points, 3>& t) const override {
        t[0].resize(s.size()), t[1].resize(s.size());
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double a = pi * s.x[i], b = angle(s.x[i], s.y[i]), r = 2 + std::cos(b);
            const Vec3 by_a{-r * std::sin(a), r * std::cos(a), 0};
            const Vec3 by_b{-std::sin(b) * std::cos(a), -std::sin(b) * std::sin(a), std::cos(b)};
            t[0].set(i, pi * by_a + 0.5 * by_b);
            t[1].set(i, 2 * pi * by_b);
        }
    }
    void to_cartesian(const Points&, const Points&, Points&) const override { FAIL(); }
    static double angle(double u, double v) { return 2 * pi * v + 0.5 * u; }
};

std::vector<Grid> grids() {
    const auto open = box_chart(box, 2, ChartEnds::open);
    Grid nodes = grid_on(open, {15, 22}, GridEnds::free);
    return {grid_on(box_chart(box, 2, ChartEnds::periodic), {18, 21}),
            grid_on(open, {20, 14}, GridEnds::reflecting),
            nodes,
            grid_on(sphere_chart(2), {30, 17}),
            grid_on(std::make_shared<TorusChart>(true), {17, 30}),
            grid_on(std::make_shared<TorusChart>(false), {17, 30}, GridEnds::reflecting)};
}

TEST(Smoothing, KeepsValuesInTheirRange) {
    // Rounding of the peak is larger than what surrounds it.
    const Grid grid = grid_on(box_chart(box, 2, ChartEnds::open), {64, 64}, GridEnds::reflecting);
    std::vector<double> values(grid.size(), 1.0);
    values[64 * 32 + 31] = 1e18;
    for (const bool gaussian : {true, false}) {
        std::vector<double> smooth = values;
        gaussian ? blur(grid, smooth, 0.05) : helmholtz_filter(grid, smooth, 0.05);
        EXPECT_GE(*std::min_element(smooth.begin(), smooth.end()), 1);
    }
}

TEST(Smoothing, KeepsMeansAndConstants) {
    for (const Grid& grid : grids())
        for (const auto& filter : {&blur, &helmholtz_filter}) {
            std::vector<double> values = noise(grid.size()), ones(grid.size(), 3.0);
            if (grid.chart->kind() == ChartKind::sphere) // a pole has one value
                for (const std::size_t row : {std::size_t{0}, grid.directions[1].count - 1})
                    std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(row * grid.directions[0].count),
                                grid.directions[0].count, 0.7);
            const double before = mean(grid, values);
            const auto [low, high] = std::minmax_element(values.begin(), values.end());
            const double spread = *high - *low;
            filter(grid, values, 0.3, {}, {});
            filter(grid, ones, 0.3, {}, {});
            EXPECT_NEAR(mean(grid, values), before, 1e-13);
            for (const double one : ones) EXPECT_NEAR(one, 3, 1e-12);
            const auto [less, more] = std::minmax_element(values.begin(), values.end());
            EXPECT_LT(*more - *less, 0.9 * spread);
        }
}

void expect_multiplied(const Grid& grid, const std::vector<double>& f, double factor, double tolerance,
                       const std::function<void(std::vector<double>&)>& filter) {
    std::vector<double> g = f;
    filter(g);
    double error = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) error = std::max(error, std::abs(g[i] - factor * f[i]));
    EXPECT_LT(error, tolerance);
}

TEST(Smoothing, MultipliesEigenfunctionsOnBoxesExactly) {
    const double sides[2] = {3, 2};
    for (const Grid& grid : grids()) {
        if (grid.chart->kind() != ChartKind::box) continue;
        const double turn = grid.directions[0].ends == GridEnds::periodic ? 2 * pi : pi;
        const double kx = 2 * turn / sides[0], ky = 3 * turn / sides[1], lambda = kx * kx + ky * ky;
        const auto f =
            sampled(grid, [&](Vec3 x) { return std::cos(kx * (x.x - box.low.x)) * std::cos(ky * x.y); });
        expect_multiplied(grid, f, std::exp(-0.5 * 0.04 * lambda), 1e-13,
                          [&](std::vector<double>& g) { blur(grid, g, 0.2); });
        expect_multiplied(grid, f, 1 / (1 + 0.04 * lambda), 1e-13,
                          [&](std::vector<double>& g) { helmholtz_filter(grid, g, 0.2); });
    }
    // In three directions and in one.
    for (const std::size_t dimension : {1, 3}) {
        const auto chart = box_chart({{0, 0, 0}, {1, 1, 1}}, dimension, ChartEnds::open);
        const Grid grid = grid_on(chart, std::vector<std::size_t>(dimension, 9), GridEnds::reflecting);
        const auto f = sampled(grid, [&](Vec3 x) { return std::cos(2 * pi * x.x) * std::cos(pi * x.z); });
        const double lambda = (dimension == 1 ? 4 : 5) * pi * pi;
        expect_multiplied(grid, f, 1 / (1 + 0.01 * lambda), 1e-13,
                          [&](std::vector<double>& g) { helmholtz_filter(grid, g, 0.1); });
    }
}

/// Error of a filter that should multiply the sampled f by the factor, at two resolutions.
void expect_order_two(const std::function<Grid(std::size_t)>& grid, const std::function<double(Vec3)>& f,
                      double factor, const std::function<void(const Grid&, std::vector<double>&)>& filter) {
    std::vector<double> errors;
    for (const std::size_t n : {24, 48}) {
        const Grid on = grid(n);
        const auto before = sampled(on, f);
        auto after = before;
        filter(on, after);
        double error = 0;
        for (std::size_t i = 0; i < on.size(); ++i)
            error = std::max(error, std::abs(after[i] - factor * before[i]));
        errors.push_back(error);
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.75) << errors[0] << " " << errors[1];
    EXPECT_LT(errors[1], 5e-3);
}

TEST(Smoothing, MultipliesSphericalHarmonicsToOrderTwo) {
    const double radius = 2;
    const auto grid = [&](std::size_t n) { return grid_on(sphere_chart(radius), {2 * n, n + 1}); };
    // Of degree 3: x y z, turned so that the poles are general points.
    const auto f = [](Vec3 x) {
        const Vec3 a{0.8, 0.36, 0.48}, b{-0.6, 0.48, 0.64}, c{0, -0.8, 0.6};
        return dot(x, a) * dot(x, b) * dot(x, c) / 8;
    };
    const double lambda = 12 / (radius * radius);
    const double length = 0.5;
    expect_order_two(grid, f, 1 / (1 + length * length * lambda),
                     [&](const Grid& on, std::vector<double>& g) { helmholtz_filter(on, g, length); });
    const double step = 1 + length * length * lambda / (2 * blur_steps);
    expect_order_two(grid, f, std::pow(step, -blur_steps),
                     [&](const Grid& on, std::vector<double>& g) { blur(on, g, length); });
}

/// The manufactured solution g = sin^2-like on the torus: f = g - L^2 Delta g with the Laplacian of the
/// torus, Delta g = g_aa / r^2 + (r g_b)_b / r.
TEST(Smoothing, SolvesTheHelmholtzEquationOnASurfaceToOrderTwo) {
    const double length = 0.7;
    const auto g = [](Vec3 x) { // a = 0 .. pi: slope zero at the ends along a, as b is open by oblique lines
        const double a = std::atan2(x.y, x.x);
        return std::cos(2 * a);
    };
    const auto f = [&](Vec3 x) {
        const double r2 = x.x * x.x + x.y * x.y;
        return g(x) * (1 + length * length * 4 / r2);
    };
    std::vector<double> errors;
    for (const std::size_t n : {16, 32}) {
        const Grid grid = grid_on(std::make_shared<TorusChart>(true), {n + 1, 2 * n});
        auto values = sampled(grid, f);
        const auto exact = sampled(grid, g);
        helmholtz_filter(grid, values, length);
        double error = 0;
        for (std::size_t i = 0; i < grid.size(); ++i) error = std::max(error, std::abs(values[i] - exact[i]));
        errors.push_back(error);
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.75) << errors[0] << " " << errors[1];
    EXPECT_LT(errors[1], 1e-2);
}

TEST(Smoothing, KeepsTheRangeOnTheSphere) {
    const Grid grid = grid_on(sphere_chart(1), {40, 21});
    for (const double length : {0.01, 0.1, 1.0}) {
        std::vector<double> values(grid.size(), 0.0);
        values[10 * 40 + 7] = 1;
        blur(grid, values, length);
        EXPECT_GE(*std::min_element(values.begin(), values.end()), -1e-15);
        EXPECT_LE(*std::max_element(values.begin(), values.end()), 1);
    }
}

TEST(Smoothing, StopsAndReportsItsProgress) {
    for (const Grid& grid : grids()) {
        std::vector<double> values = noise(grid.size());
        std::stop_source source;
        double last = -1;
        blur(grid, values, 0.1, [&](double done, std::string_view) { last = std::max(last, done); });
        EXPECT_GT(last, 0);
        EXPECT_LE(last, 1);
        source.request_stop();
        EXPECT_THROW(blur(grid, values, 0.1, {}, source.get_token()), Interrupted);
    }
}

} // namespace
} // namespace gaspard
