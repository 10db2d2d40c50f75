#include "core/mesh/chart.hpp"
#include "core/spline/spline_domain.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

Points some_coordinates(const Chart& chart) {
    Points s(40);
    for (std::size_t i = 0; i < s.size(); ++i) {
        const auto at = [&](std::size_t d, double stride) {
            const ChartDirection& direction = chart.direction(d);
            const double part = 0.03 + 0.94 * std::fmod(stride * static_cast<double>(i), 1.0);
            return direction.low + part * (direction.high - direction.low);
        };
        s.set(i, {at(0, 0.37), at(1, 0.61), 0});
    }
    return s;
}

/// Points and coordinates are inverse to each other, tangents are derivatives of the points, and the gradient
/// of a function of the coordinates has its derivatives along the tangents.
void expect_consistent(const Chart& chart) {
    const Points s = some_coordinates(chart);
    Points x, back, ahead, behind;
    chart.points(s, x);
    chart.coordinates(x, back);
    std::array<Points, 3> t;
    chart.tangents(s, t);
    Points g(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) g.set(i, {1 + s.x[i], 2 - s.y[i], 0});
    const Points derivatives = g;
    chart.to_cartesian(x, s, g);
    for (std::size_t d = 0; d < 2; ++d) {
        const double step = 1e-6 * (chart.direction(d).high - chart.direction(d).low);
        Points plus = s, minus = s;
        auto& up = d == 0 ? plus.x : plus.y;
        auto& down = d == 0 ? minus.x : minus.y;
        for (double& c : up) c += step;
        for (double& c : down) c -= step;
        chart.points(plus, ahead);
        chart.points(minus, behind);
        for (std::size_t i = 0; i < s.size(); ++i) {
            const Vec3 slope = (0.5 / step) * (ahead[i] - behind[i]);
            EXPECT_LT(norm(slope - t[d][i]), 1e-6 * (1 + norm(slope)));
            const double expected = d == 0 ? derivatives.x[i] : derivatives.y[i];
            EXPECT_NEAR(dot(g[i], t[d][i]), expected, 1e-9 * (1 + std::abs(expected)));
        }
    }
    for (std::size_t i = 0; i < s.size(); ++i) EXPECT_LT(norm(back[i] - s[i]), 1e-7) << i;
}

TEST(Chart, IsConsistentOnEveryDomain) {
    expect_consistent(*box_chart({{-1, 0, 0}, {2, 5, 0}}, 2, ChartEnds::open));
    expect_consistent(*sphere_chart(3));
    const DomainType torus = [] {
        for (DomainType& type : spline_domains())
            if (type.name == "spline-torus") return type;
        return DomainType{};
    }();
    Values values("domain", torus.rows);
    values.set("cells", std::int64_t{4});
    const auto domain = make_spline_domain(torus.name, values);
    const auto chart =
        chart_of({.space = {.kind = SpaceKind::euclidean, .dimension = 3}, .discretisation = domain.get()});
    EXPECT_EQ(chart->kind(), ChartKind::surface);
    expect_consistent(*chart);
}

TEST(Chart, HasTheBoxOfAPatchWhateverItsMesh) {
    for (const std::int64_t cells : {4, 5}) {
        const DomainType disk = [] {
            for (DomainType& type : spline_domains())
                if (type.name == "spline-disk") return type;
            return DomainType{};
        }();
        Values values("domain", disk.rows);
        values.set("cells", cells);
        const auto domain = make_spline_domain(disk.name, values);
        const auto chart = chart_of({.space = {}, .discretisation = domain.get()});
        EXPECT_EQ(chart->kind(), ChartKind::box);
        for (std::size_t d = 0; d < 2; ++d) {
            EXPECT_NEAR(chart->direction(d).low, -1, 1e-12);
            EXPECT_NEAR(chart->direction(d).high, 1, 1e-12);
        }
    }
}

TEST(Chart, OfThePlaneAndTheSphere) {
    EXPECT_EQ(chart_of({.space = {SpaceKind::periodic_square}})->direction(1).ends, ChartEnds::periodic);
    const auto sphere = chart_of({.space = {SpaceKind::sphere}});
    EXPECT_EQ(sphere->direction(0).ends, ChartEnds::periodic);
    EXPECT_EQ(sphere->direction(1).ends, ChartEnds::poles);
    Points s(1), x;
    s.set(0, {90, 0, 0});
    sphere->points(s, x);
    EXPECT_LT(norm(x[0] - Vec3{0, 1, 0}), 1e-15);
}

} // namespace
} // namespace gaspard
