// The linearisation of the discrete Monge-Ampere equation, against differences of its residual.
#include "core/linear/dense.hpp"
#include "core/linear/gmres.hpp"
#include "core/method/plane_equation.hpp"
#include "core/method/surface_equation.hpp"
#include "support/built_in.hpp"
#include "support/polynomials.hpp"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

using Vector = std::vector<double>;
using Linearised = NonlinearProblem::Linearised;

struct Case {
    const char* name;
    std::function<std::unique_ptr<NonlinearProblem>()> make;
    std::shared_ptr<const Monitor> monitor;
};

Case plane(const char* name, std::size_t cells, bool periodic) {
    return {name,
            [=]() -> std::unique_ptr<NonlinearProblem> {
                return std::make_unique<PlaneEquation>(std::make_shared<PlaneQ2>(LineGrid{cells, periodic}));
            },
            make_monitor("bell", periodic ? Space{SpaceKind::periodic_square} : Space{},
                         {{"amplitude", 4}, {"sharpness", 20}, {"center_x", 0.4}})};
}

Case sphere(const char* name, SphereCells cells, int resolution, int geometry_order, double radius,
            bool monitor_at_vertices = false) {
    return {name,
            [=]() -> std::unique_ptr<NonlinearProblem> {
                return std::make_unique<SurfaceEquation>(
                    std::make_shared<SurfaceQ2>(sphere_setup({.cells = cells, .resolution = resolution},
                                                             geometry_order, radius, monitor_at_vertices)));
            },
            make_monitor("bell", {SpaceKind::sphere}, {{"amplitude", 4}, {"sharpness", 2}})};
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

class Linearisation : public testing::TestWithParam<Case> {
  protected:
    Linearisation() : equation(GetParam().make()) {
        w = smooth(4);
        phi = smooth(3);
    }
    /// The relaxation's direction for random values of m: as smooth as potentials are.
    Vector smooth(unsigned seed) {
        const Vector nothing(equation->size(), 0.0);
        equation->evaluate(problem_of(*GetParam().monitor), nothing);
        const Frozen frozen(slow::random_values(equation->positions().size(), 1, 1.3, seed));
        equation->evaluate(problem_of(frozen), nothing);
        Vector u(nothing.size());
        equation->direction(u);
        return u;
    }
    Vector derivative(const Vector& direction, Linearised how) {
        equation->evaluate(problem_of(*GetParam().monitor), phi);
        equation->linearise(problem_of(*GetParam().monitor), how);
        Vector out(phi.size(), 7.0);
        equation->derivative(direction, out);
        return out;
    }
    Vector residual(const Monitor& of, const Vector& at) {
        equation->evaluate(problem_of(of), at);
        return {equation->residual().begin(), equation->residual().end()};
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

    std::unique_ptr<NonlinearProblem> equation;
    Vector phi, w;
};

TEST_P(Linearisation, IsTheLimitOfDifferences) {
    const Vector exact = derivative(w, Linearised::fully);
    const double coarse = relative(difference(*GetParam().monitor, 1e-1), exact);
    const double fine = relative(difference(*GetParam().monitor, 1e-4), exact);
    EXPECT_LT(fine, 1e-6);
    EXPECT_LT(fine, 1e-2 * coarse);
}

TEST_P(Linearisation, LeavesOutWhatThePaperLeavesOut) {
    const Vector exact = derivative(w, Linearised::frozen_monitor);
    Vector values(equation->positions().size());
    GetParam().monitor->values(equation->positions(), values);
    EXPECT_LT(relative(difference(Frozen(values), 1e-4), exact), 1e-6);
    EXPECT_GT(relative(difference(*GetParam().monitor, 1e-4), exact), 1e-2); // and it is another matrix
}

TEST_P(Linearisation, IsLinearAndBlindToConstants) {
    const Vector one(phi.size(), 1.0), of_one = derivative(one, Linearised::fully);
    Vector sum = w;
    for (double& value : sum) value = 2 * value + 0.01;
    const Vector of_w = derivative(w, Linearised::fully), of_sum = derivative(sum, Linearised::fully);
    double total = 0, largest = 0;
    for (const double value : of_w) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < w.size(); ++i) {
        EXPECT_NEAR(of_sum[i], 2 * of_w[i], 1e-8 * largest);
        EXPECT_NEAR(of_one[i], 0, 1e-6 * largest);
        total += of_w[i];
    }
    EXPECT_NEAR(total, 0, 1e-11 * largest * static_cast<double>(w.size())); // theta takes the mean
}

// Column by column as a matrix: what GMRES finds with the preconditioner is what a dense factorisation finds.
TEST_P(Linearisation, IsThatOfADenseMatrix) {
    const auto n = static_cast<Eigen::Index>(phi.size());
    const auto& monitor = *GetParam().monitor;
    const Vector r = residual(monitor, phi);
    equation->linearise(problem_of(monitor), Linearised::fully);
    Eigen::MatrixXd matrix(n, n);
    Vector unit(phi.size()), column(phi.size());
    for (Eigen::Index k = 0; k < n; ++k) {
        std::fill(unit.begin(), unit.end(), 0.0);
        unit[static_cast<std::size_t>(k)] = 1;
        equation->derivative(unit, column);
        matrix.col(k) = Eigen::Map<const Eigen::VectorXd>(column.data(), n);
    }
    equation->derivative(w, column);
    const Eigen::VectorXd dense_w = matrix * Eigen::Map<const Eigen::VectorXd>(w.data(), n);
    EXPECT_LT(relative({dense_w.data(), dense_w.data() + n}, column), 1e-10);

    Gmres gmres(phi.size(), 60);
    Vector u(phi.size());
    const auto result =
        gmres.solve([&](auto v, auto out) { equation->derivative(v, out); },
                    [&](auto v, auto out) { equation->precondition(v, out); }, r, u, {1e-11, 120});
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.iterations, 60);
    // The constant is the kernel of the matrix, and the sum over its rows vanishes.
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(r.data(), n);
    const Eigen::MatrixXd regular =
        matrix + Eigen::MatrixXd::Constant(n, n, matrix.norm() / static_cast<double>(n));
    Eigen::VectorXd expected = slow::solve(regular, b);
    Eigen::VectorXd ours = Eigen::Map<const Eigen::VectorXd>(u.data(), n);
    expected.array() -= expected.mean();
    ours.array() -= ours.mean();
    EXPECT_LT((ours - expected).norm(), 1e-7 * expected.norm());
}

TEST_P(Linearisation, IsPreconditionedByAPositiveSymmetricOperator) {
    derivative(w, Linearised::fully);
    const Vector a = slow::random_values(phi.size(), -1, 1, 5), b = slow::random_values(phi.size(), -1, 1, 6);
    Vector pa(phi.size()), pb(phi.size());
    equation->precondition(a, pa);
    equation->precondition(b, pb);
    double ab = 0, ba = 0, aa = 0;
    for (std::size_t i = 0; i < phi.size(); ++i) ab += b[i] * pa[i], ba += a[i] * pb[i], aa += a[i] * pa[i];
    EXPECT_GT(aa, 0);
    EXPECT_NEAR(ab, ba, 1e-10 * aa);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Linearisation,
                         testing::Values(plane("Periodic6", 6, true), plane("Walls6", 6, false),
                                         plane("Periodic9", 9, true), plane("Walls7", 7, false),
                                         sphere("Cubed", SphereCells::cubed, 3, 2, 1),
                                         sphere("CubedOfRadius2", SphereCells::cubed, 3, 2, 2),
                                         sphere("CubedFlatFacets", SphereCells::cubed, 4, 1, 1),
                                         sphere("CubedMonitorAtVertices", SphereCells::cubed, 4, 2, 1, true),
                                         sphere("Icosahedral", SphereCells::icosahedral, 1, 2, 1)),
                         [](const auto& one) { return std::string(one.param.name); });

} // namespace
} // namespace gaspard
