#include "core/base/error.hpp"
#include "core/fem/plane_q2.hpp"
#include "core/fem/slow_plane.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

using slow::Jet, slow::Place, slow::Vector;

Vector vector_of(std::span<const double> values) {
    return Vector::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

double relative(const Vector& ours, const Vector& expected) {
    return slow::largest(ours - expected) / slow::largest(expected);
}

// Random potential, and random positive values of the monitor at the mesh's nodes.
class Operators : public testing::TestWithParam<std::tuple<int, bool>> {
  protected:
    int n() const { return std::get<0>(GetParam()); }
    bool periodic() const { return std::get<1>(GetParam()); }

    PlaneQ2 plane{LineGrid{static_cast<std::size_t>(n()), periodic()}};
    slow::Plane slowly{n(), periodic()};
    PlaneQ2::Workspace workspace = plane.make_workspace();
    std::vector<double> phi = slow::random_values(plane.unknowns(), -0.01, 0.01, 7);
    Vector potential = vector_of(phi);

    std::vector<double> random_monitor() const {
        std::vector<double> m = slow::random_values(plane.mesh()->node_count(), 0.5, 3, 8);
        const std::size_t side = static_cast<std::size_t>(n()) + 1;
        for (std::size_t k = 0; periodic() && k < side; ++k) m[k * side + side - 1] = m[k * side];
        for (std::size_t k = 0; periodic() && k < side; ++k) m[(side - 1) * side + k] = m[k];
        return m;
    }
};

INSTANTIATE_TEST_SUITE_P(Planes, Operators, testing::Combine(testing::Values(4, 5, 6), testing::Bool()));

TEST_P(Operators, MovesNodesByTheProjectedGradient) {
    Points x;
    plane.positions(phi, x, workspace);
    const Vector dx = slowly.project(
        1,
        slowly.load(1, [&](const Jet& v, const Place& p) { return v.value * slowly.at(2, potential, p).dx; }),
        {.on_x = true});
    const Vector dy = slowly.project(
        1,
        slowly.load(1, [&](const Jet& v, const Place& p) { return v.value * slowly.at(2, potential, p).dy; }),
        {.on_y = true});
    ASSERT_EQ(x.size(), static_cast<std::size_t>((n() + 1) * (n() + 1)));
    for (int j = 0; j <= n(); ++j)
        for (int i = 0; i <= n(); ++i) {
            const auto node = static_cast<std::size_t>(j * (n() + 1) + i);
            const int unknown = j % slowly.side(1) * slowly.side(1) + i % slowly.side(1);
            EXPECT_NEAR(x.x[node], static_cast<double>(i) / n() + dx[unknown], 1e-14);
            EXPECT_NEAR(x.y[node], static_cast<double>(j) / n() + dy[unknown], 1e-14);
            EXPECT_EQ(x.z[node], 0);
        }
}

TEST_P(Operators, HasTheWeakHessianOfThePaper) {
    WeakHessian sigma;
    plane.hessian(phi, sigma, workspace);
    // (3.8) with tau = t e_1 e_1, t e_2 e_2, and t (e_1 e_2 + e_2 e_1): div tau is (t_x, 0), (0, t_y), (t_y,
    // t_x).
    const auto load = [&](const std::function<double(const Jet& t, const Jet& f)>& divergence) {
        return slowly.load(
            2, [&](const Jet& t, const Place& p) { return -divergence(t, slowly.at(2, potential, p)); });
    };
    const Vector xx = slowly.project(2, load([](const Jet& t, const Jet& f) { return t.dx * f.dx; }));
    const Vector yy = slowly.project(2, load([](const Jet& t, const Jet& f) { return t.dy * f.dy; }));
    const Vector xy =
        slowly.project(2, load([](const Jet& t, const Jet& f) { return (t.dy * f.dx + t.dx * f.dy) / 2; }),
                       {.on_x = true, .on_y = true});
    EXPECT_LT(relative(vector_of(sigma.xx), xx), 1e-11);
    EXPECT_LT(relative(vector_of(sigma.yy), yy), 1e-11);
    EXPECT_LT(relative(vector_of(sigma.xy), xy), 1e-11);
}

TEST_P(Operators, EvaluatesTheResidualExactly) {
    const std::vector<double> monitor = random_monitor();
    WeakHessian sigma;
    for (auto* part : {&sigma.xx, &sigma.yy, &sigma.xy})
        *part = slow::random_values(plane.unknowns(), -1, 2, static_cast<unsigned>(part - &sigma.xx) + 11);
    std::vector<double> r(plane.unknowns(), 5.0);
    const auto [theta, normalised] = plane.residual(monitor, sigma, r, workspace);

    // m in Q1 on the unwrapped mesh, sigma in Q2.
    const Vector xx = vector_of(sigma.xx), yy = vector_of(sigma.yy), xy = vector_of(sigma.xy);
    const auto density = [&](const Place& p) {
        double m = 0;
        for (int b : {0, 1})
            for (int a : {0, 1})
                m += monitor[static_cast<std::size_t>((p.j + b) * (n() + 1) + p.i + a)] *
                     slowly.basis(1, a, b, p.p, p.q).value;
        const double sxy = slowly.at(2, xy, p).value;
        return m * ((1 + slowly.at(2, xx, p).value) * (1 + slowly.at(2, yy, p).value) - sxy * sxy);
    };
    double expected_theta = 0;
    slowly.for_each_place([&](const Place& p) { expected_theta += p.weight * density(p); });
    const Vector expected =
        slowly.load(2, [&](const Jet& v, const Place& p) { return v.value * (density(p) - expected_theta); });
    const Vector scale = slowly.load(2, [&](const Jet& v, const Place&) { return v.value * expected_theta; });
    EXPECT_NEAR(theta, expected_theta, 1e-12 * std::abs(expected_theta));
    EXPECT_LT(relative(vector_of(r), expected), 1e-11);
    EXPECT_NEAR(normalised, expected.norm() / scale.norm(), 1e-11 * normalised);
}

TEST_P(Operators, SolvesThePoissonProblem) {
    const std::vector<double> r = slow::random_values(plane.unknowns(), -1, 2, 21); // of non-zero mean
    std::vector<double> u(plane.unknowns());
    plane.poisson(r, u, workspace);
    const Eigen::Index all = slowly.unknowns(2);
    const Vector weights = slowly.load(2, [](const Jet& v, const Place&) { return v.value; });
    Eigen::MatrixXd bordered = Eigen::MatrixXd::Zero(all + 1, all + 1);
    bordered.topLeftCorner(all, all) =
        slowly.matrix(2, [](const Jet& v, const Jet& f) { return v.dx * f.dx + v.dy * f.dy; });
    bordered.topRightCorner(all, 1) = weights;
    bordered.bottomLeftCorner(1, all) = weights.transpose();
    Vector right(all + 1);
    right << vector_of(r), 0;
    const Vector expected = slow::solve(bordered, right).topRows(all);
    EXPECT_LT(relative(vector_of(u), expected), 1e-11);
    EXPECT_NEAR(weights.dot(vector_of(u)), 0, 1e-12);
    std::vector<double> same = r;
    plane.poisson(same, same, workspace);
    EXPECT_EQ(same, u);
}

TEST_P(Operators, IgnoreConstantsInPhi) {
    std::vector<double> raised = phi;
    for (double& value : raised) value += 1;
    Points x, x_raised;
    WeakHessian sigma, sigma_raised;
    plane.positions(phi, x, workspace);
    plane.positions(raised, x_raised, workspace);
    plane.hessian(phi, sigma, workspace);
    plane.hessian(raised, sigma_raised, workspace);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(norm(x[i] - x_raised[i]), 0, 1e-13);
    for (std::size_t i = 0; i < plane.unknowns(); ++i) {
        EXPECT_NEAR(sigma.xx[i], sigma_raised.xx[i], 1e-11);
        EXPECT_NEAR(sigma.yy[i], sigma_raised.yy[i], 1e-11);
        EXPECT_NEAR(sigma.xy[i], sigma_raised.xy[i], 1e-11);
    }
}

TEST_P(Operators, RejectArraysOfTheWrongSize) {
    Points x;
    WeakHessian sigma;
    const std::vector<double> few(plane.unknowns() - 1);
    std::vector<double> out(plane.unknowns());
    EXPECT_THROW(plane.positions(few, x, workspace), InternalError);
    EXPECT_THROW(plane.hessian(few, sigma, workspace), InternalError);
    EXPECT_THROW(plane.poisson(few, out, workspace), InternalError);
    EXPECT_THROW(plane.residual(few, sigma, out, workspace), InternalError);
}

// A smooth potential that suits both boundaries: periodic and even about 0, 1/2 and 1.
double smooth(double x, double y) {
    const double w = 2 * std::numbers::pi;
    return 0.004 * std::cos(w * x) * std::cos(w * y) + 0.002 * std::cos(2 * w * x);
}

std::vector<double> interpolate(const PlaneQ2& plane) {
    std::vector<double> phi(plane.unknowns());
    const std::size_t n = plane.size();
    const double h = plane.grid().h() / 2;
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
            phi[j * n + i] = smooth(h * static_cast<double>(i), h * static_cast<double>(j));
    return phi;
}

// The largest distance between node (i, j) of the coarse mesh under phi and (2 i, 2 j) of the fine one.
double drift_on_refining(std::size_t cells, bool periodic) {
    PlaneQ2 coarse({cells, periodic}), fine({2 * cells, periodic});
    auto coarse_workspace = coarse.make_workspace(), fine_room = fine.make_workspace();
    const std::vector<double> phi = interpolate(coarse);
    Points x, y;
    coarse.positions(phi, x, coarse_workspace);
    fine.positions(fine.transfer(coarse.grid(), phi, fine_room), y, fine_room);
    double drift = 0;
    for (std::size_t j = 0; j <= cells; ++j)
        for (std::size_t i = 0; i <= cells; ++i)
            drift = std::max(drift, norm(x[j * (cells + 1) + i] - y[2 * j * (2 * cells + 1) + 2 * i]));
    return drift;
}

TEST(Transfer, KeepsPositionsToTheOrderOfTheirProjection) {
    for (const bool periodic : {true, false}) {
        const double at_10 = drift_on_refining(10, periodic), at_20 = drift_on_refining(20, periodic),
                     at_40 = drift_on_refining(40, periodic);
        EXPECT_LT(at_40, 3e-4); // where nodes move by up to 0.05
        EXPECT_NEAR(std::log2(at_20 / at_40), 2, 0.1) << at_10 << " " << at_20 << " " << at_40;
    }
}

// The largest difference after a transfer to another grid and back, relative to the largest potential.
double loss(std::size_t cells, std::size_t other, bool periodic) {
    PlaneQ2 here({cells, periodic}), there({other, periodic});
    auto workspace = here.make_workspace(), room_there = there.make_workspace();
    const std::vector<double> phi = interpolate(here);
    const auto back = here.transfer(there.grid(), there.transfer(here.grid(), phi, room_there), workspace);
    return slow::largest(vector_of(back) - vector_of(phi)) / 0.006;
}

TEST(Transfer, IsLosslessToTwiceTheCellsAndBack) {
    for (const bool periodic : {true, false})
        for (const std::size_t cells : {5, 10, 16}) EXPECT_LT(loss(cells, 2 * cells, periodic), 1e-12);
}

TEST(Transfer, LosesLittleToFewerCellsAndBack) {
    for (const bool periodic : {true, false}) {
        const double at_40 = loss(40, 26, periodic), at_80 = loss(80, 52, periodic);
        EXPECT_LT(at_80, 1e-5);
        EXPECT_GT(std::log2(at_40 / at_80), 3) << at_40 << " " << at_80;
    }
}

TEST(Transfer, OnTheSameGridIsExactToRounding) {
    for (const bool periodic : {true, false}) {
        PlaneQ2 plane({12, periodic});
        auto workspace = plane.make_workspace();
        const std::vector<double> phi = interpolate(plane);
        const auto same = plane.transfer(plane.grid(), phi, workspace);
        EXPECT_LT(slow::largest(vector_of(same) - vector_of(phi)), 1e-14);
    }
}

} // namespace
} // namespace gaspard
