// The linearisation of the discrete Monge-Ampere equation, against differences of its residual.
#include "core/fem/slow_plane.hpp"
#include "core/linear/dense.hpp"
#include "core/linear/gmres.hpp"
#include "core/method/plane_equation.hpp"
#include "support/built_in.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

using Vector = std::vector<double>;
using Linearised = Equation::Linearised;

struct Case {
    bool periodic;
    std::size_t cells;
};

class Linearisation : public testing::TestWithParam<Case> {
  protected:
    Linearisation() : equation(std::make_shared<PlaneQ2>(LineGrid{GetParam().cells, GetParam().periodic})) {
        const Vector rough = slow::random_values(equation.unknowns(), -1, 1, 3);
        const Vector rough_w = slow::random_values(equation.unknowns(), -1, 1, 4);
        phi = smooth(rough, 2e-3), w = smooth(rough_w, 2e-3);
    }
    /// Poisson's solution for a random right-hand side, so that its second derivatives are of that size.
    Vector smooth(const Vector& rough, double size) {
        PlaneQ2 plane({GetParam().cells, GetParam().periodic});
        auto room = plane.make_room();
        Vector u(rough.size());
        plane.poisson(rough, u, room);
        for (double& value : u) value *= size;
        return u;
    }
    Vector derivative(const Vector& direction, Linearised how) {
        equation.evaluate(*monitor, phi);
        equation.linearise(*monitor, how);
        Vector out(phi.size(), 7.0);
        equation.derivative(direction, out);
        return out;
    }
    Vector residual(const Monitor& of, const Vector& at) {
        equation.evaluate(of, at);
        return {equation.residual().begin(), equation.residual().end()};
    }
    /// -(r(phi + e w) - r(phi - e w)) / 2 e
    Vector difference(const Monitor& of, double e) {
        Vector there = phi, back = phi;
        for (std::size_t i = 0; i < phi.size(); ++i) there[i] += e * w[i], back[i] -= e * w[i];
        const Vector r = residual(of, there), r_back = residual(of, back);
        Vector d(r.size());
        for (std::size_t i = 0; i < r.size(); ++i) d[i] = (r_back[i] - r[i]) / (2 * e);
        return d;
    }
    static double relative(const Vector& a, const Vector& b) {
        double distance = 0, size = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            distance += (a[i] - b[i]) * (a[i] - b[i]), size += b[i] * b[i];
        return std::sqrt(distance / size);
    }

    std::shared_ptr<const Monitor> monitor =
        make_monitor("bell", GetParam().periodic ? Space{SpaceKind::periodic_square} : Space{},
                     {{"amplitude", 4}, {"sharpness", 20}, {"center_x", 0.4}});
    PlaneEquation equation;
    Vector phi, w;
};

TEST_P(Linearisation, IsTheLimitOfDifferences) {
    const Vector exact = derivative(w, Linearised::fully);
    const double coarse = relative(difference(*monitor, 1e-1), exact);
    const double fine = relative(difference(*monitor, 1e-3), exact);
    EXPECT_LT(fine, 1e-6);
    EXPECT_LT(fine, 1e-2 * coarse);
}

/// What a monitor was at one potential: it does not move.
struct Frozen final : Monitor {
    explicit Frozen(Vector all) : all_(std::move(all)) {}
    void values(const Points&, std::span<double> values) const override {
        std::copy(all_.begin(), all_.end(), values.begin());
    }
    void gradients(const Points&, Points&) const override { FAIL(); }
    void check() const override {}
    Vector all_;
};

TEST_P(Linearisation, LeavesOutWhatThePaperLeavesOut) {
    const Vector exact = derivative(w, Linearised::frozen_monitor);
    Vector values(equation.positions().size());
    monitor->values(equation.positions(), values);
    EXPECT_LT(relative(difference(Frozen(values), 1e-3), exact), 1e-6);
    EXPECT_GT(relative(difference(*monitor, 1e-3), exact), 1e-2); // and it is another matrix
}

TEST_P(Linearisation, IsLinearAndBlindToConstants) {
    const Vector one(phi.size(), 1.0), of_one = derivative(one, Linearised::fully);
    Vector sum = w, twice = w;
    for (std::size_t i = 0; i < w.size(); ++i) sum[i] = 2 * w[i] + 5;
    const Vector of_w = derivative(w, Linearised::fully), of_sum = derivative(sum, Linearised::fully);
    double total = 0, largest = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
        EXPECT_NEAR(of_sum[i], 2 * of_w[i], 1e-9);
        EXPECT_NEAR(of_one[i], 0, 1e-10);
        total += of_w[i];
        largest = std::max(largest, std::abs(of_w[i]));
    }
    EXPECT_NEAR(total, 0, 1e-11 * largest * static_cast<double>(w.size())); // theta takes the mean
}

// Column by column as a matrix: nearly symmetric and positive where the map is convex, and what GMRES finds
// with the preconditioner is what a dense factorisation finds.
TEST_P(Linearisation, IsThatOfADenseMatrix) {
    const auto n = static_cast<Eigen::Index>(phi.size());
    Eigen::MatrixXd matrix(n, n);
    Vector unit(phi.size());
    for (Eigen::Index k = 0; k < n; ++k) {
        std::fill(unit.begin(), unit.end(), 0.0);
        unit[static_cast<std::size_t>(k)] = 1;
        const Vector column = derivative(unit, Linearised::fully);
        matrix.col(k) = Eigen::Map<const Eigen::VectorXd>(column.data(), n);
    }
    const Vector of_w = derivative(w, Linearised::fully);
    const Eigen::VectorXd dense_w = matrix * Eigen::Map<const Eigen::VectorXd>(w.data(), n);
    EXPECT_LT(relative({dense_w.data(), dense_w.data() + n}, of_w), 1e-11);

    const Vector r = residual(*monitor, phi);
    equation.linearise(*monitor, Linearised::fully);
    Gmres gmres(phi.size(), 60);
    Vector u(phi.size());
    const auto result =
        gmres.solve([&](auto v, auto out) { equation.derivative(v, out); },
                    [&](auto v, auto out) { equation.precondition(v, out); }, r, u, {1e-11, 120});
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.iterations, 60);
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(r.data(), n);
    const Eigen::MatrixXd regular = matrix + Eigen::MatrixXd::Constant(n, n, 1.0 / static_cast<double>(n));
    Eigen::VectorXd expected = regular.partialPivLu().solve(b);
    Eigen::VectorXd ours = Eigen::Map<const Eigen::VectorXd>(u.data(), n);
    expected.array() -= expected.mean();
    ours.array() -= ours.mean();
    EXPECT_LT((ours - expected).norm(), 1e-8 * expected.norm());
}

INSTANTIATE_TEST_SUITE_P(Planes, Linearisation,
                         testing::Values(Case{true, 6}, Case{false, 6}, Case{true, 9}, Case{false, 7}),
                         [](const auto& one) {
                             return std::string(one.param.periodic ? "Periodic" : "Walls") +
                                    std::to_string(one.param.cells);
                         });

} // namespace
} // namespace gaspard
