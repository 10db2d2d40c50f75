#include "core/base/error.hpp"
#include "core/fem/exponential_map.hpp"
#include "core/fem/slow_surface.hpp"
#include "core/fem/surface_q2.hpp"
#include "core/method/surface_equation.hpp"
#include "support/built_in.hpp"
#include "support/periodic_surface.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

struct Case {
    std::string name;
    SurfaceSetup setup;
    bool flat = false;
};

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const int order : {1, 2})
        for (const bool at_vertices : {false, true}) {
            const std::string name =
                " of order " + std::to_string(order) + (at_vertices ? ", monitor at vertices" : "");
            list.push_back({"squares" + name, sphere_setup({SphereCells::cubed, 2}, order, 1, at_vertices)});
            list.push_back(
                {"triangles" + name, sphere_setup({SphereCells::icosahedral, 0}, order, 1, at_vertices)});
        }
    list.push_back({"equiangular", sphere_setup({SphereCells::cubed, 3, MidNodes::equiangular})});
    for (const auto shape : {CellShape::quadrilateral, CellShape::triangle})
        for (const int order : {1, 2}) list.push_back({"flat", periodic_surface(3, shape, order), true});
    return list;
}

/// Smooth, with gradients that are a fraction of the radius.
std::vector<double> some_potential(std::size_t size, double amplitude) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> value(-amplitude, amplitude);
    std::vector<double> phi(size);
    for (double& v : phi) v = value(random);
    return phi;
}
slow::Vector as_vector(const std::vector<double>& v) {
    return Eigen::Map<const slow::Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
}

TEST(ExponentialMap, HasCosineAndSineOverT) {
    for (int i = 0; i <= 100; ++i) {
        const double t = 2 * std::numbers::pi * i / 100, tolerance = t <= std::numbers::pi ? 4e-15 : 1e-11;
        const auto [cosine, sinc] = cosine_and_sinc(t * t);
        EXPECT_NEAR(cosine, std::cos(t), tolerance);
        EXPECT_NEAR(sinc, t == 0 ? 1 : std::sin(t) / t, tolerance);
    }
}

TEST(CellQuadrature, OfDegree8IsExactForPolynomialsOfDegree8) {
    for (const auto shape : {CellShape::triangle, CellShape::quadrilateral})
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= (shape == CellShape::triangle ? 8 - i : 8); ++j) {
                double sum = 0;
                for (const auto& [p, weight] : quadrature_of_degree_8(shape))
                    sum += weight * std::pow(p.x, i) * std::pow(p.y, j);
                const double exact = shape == CellShape::triangle
                                         ? std::tgamma(i + 1) * std::tgamma(j + 1) / std::tgamma(i + j + 3)
                                         : 1.0 / ((i + 1) * (j + 1));
                EXPECT_NEAR(sum / exact, 1, 1e-14);
            }
}

TEST(SurfaceQ2, AgreesWithDenseMatrices) {
    for (auto& [name, setup, flat] : cases()) {
        SCOPED_TRACE(name);
        const slow::Surface slow(setup.mesh, setup.geometry_order, flat, setup.unknowns);
        const SurfaceQ2 surface(setup);
        ASSERT_EQ(static_cast<Eigen::Index>(surface.unknowns()), slow.size());
        EXPECT_NEAR(surface.area(), slow.weights().sum(), 1e-13);
        const auto phi = some_potential(surface.unknowns(), flat ? 0.002 : 0.05);
        auto workspace = surface.make_workspace();
        surface.map(phi, workspace);

        const std::size_t nodes = surface.mesh()->node_count();
        const Eigen::MatrixXd sigma = slow.sigma(as_vector(phi)), w = slow.projected_gradient(as_vector(phi));
        Points x, gradient;
        surface.positions(workspace, x, gradient);
        for (std::size_t i = 0; i < nodes; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            const auto unknown = setup.unknowns.empty() ? row : setup.unknowns[i];
            for (std::size_t c = 0; c < 9; ++c)
                ASSERT_NEAR(surface.sigma(workspace, i)[c], sigma(unknown, static_cast<Eigen::Index>(c)),
                            1e-11);
            const Vec3 p = surface.places()[i];
            const Eigen::Vector3d xi(p.x, p.y, p.z);
            Eigen::Vector3d g = w.row(row).transpose();
            if (!flat) g -= g.dot(xi) * xi;
            const Eigen::Vector3d expected = flat ? (xi + g).eval() : slow::Surface::exponential(xi, g);
            ASSERT_NEAR(norm(gradient[i] - Vec3{g.x(), g.y(), g.z()}), 0, 1e-12);
            ASSERT_NEAR(norm(x[i] - Vec3{expected.x(), expected.y(), expected.z()}), 0, 1e-12);
        }

        std::vector<double> monitor(nodes), r(surface.unknowns());
        for (std::size_t i = 0; i < nodes; ++i) monitor[i] = 1.5 + x.x[i] * x.y[i];
        const auto [theta, normalised] = surface.residual(monitor, r, workspace);
        slow::Vector load = slow.determinant_load(as_vector(phi), monitor, setup.monitor_at_vertices);
        const double expected_theta = load.sum() / slow.weights().sum();
        EXPECT_NEAR(theta, expected_theta, 1e-12);
        load -= expected_theta * slow.weights();
        EXPECT_NEAR(normalised, load.norm() / (expected_theta * slow.weights()).norm(), 1e-11);
        EXPECT_LT((as_vector(r) - load).norm(), 1e-11 * load.norm());

        std::vector<double> u(surface.unknowns());
        surface.poisson(r, u, workspace);
        EXPECT_LT((slow.stiffness() * as_vector(u) - load).norm(), 1e-11 * load.norm());
        EXPECT_NEAR(slow.weights().dot(as_vector(u)), 0, 1e-12);

        const auto l = surface.laplacian(phi);
        EXPECT_LT((slow.mass() * as_vector(l) + slow.stiffness() * as_vector(phi)).norm(), 1e-10);
        const auto again = surface.potential(l);
        const double mean = slow.weights().dot(as_vector(phi)) / slow.weights().sum();
        for (std::size_t i = 0; i < phi.size(); ++i) ASSERT_NEAR(again[i], phi[i] - mean, 1e-12);
    }
}

TEST(SurfaceQ2, EllipticityMatchesFiniteDifferences) {
    // adj(A) D, with D from finite differences of the exponential map and an explicit adjugate.
    class Waves final : public Monitor {
        void values(const Points& x, std::span<double> values) const override {
            for (std::size_t i = 0; i < values.size(); ++i) values[i] = 2 + x.x[i] + 0.5 * x.y[i] * x.z[i];
        }
        void gradients(const Points&, Points&) const override {}
        void check() const override {}
    };
    const auto surface = std::make_shared<const SurfaceQ2>(sphere_setup({SphereCells::cubed, 3}));
    SurfaceEquation equation(surface);
    std::vector<double> phi(surface->unknowns());
    for (std::size_t i = 0; i < phi.size(); ++i) {
        const Vec3 p = surface->places()[i];
        phi[i] = 0.1 * p.x * p.y + 0.2 * p.z;
    }
    const Waves waves;
    equation.evaluate({.monitor = std::shared_ptr<const Monitor>(std::shared_ptr<const Monitor>(), &waves)},
                      phi);
    auto workspace = surface->make_workspace();
    surface->map(phi, workspace);
    Points x, gradient;
    surface->positions(workspace, x, gradient);
    std::vector<double> m(x.size());
    static_cast<const Monitor&>(Waves()).values(x, m);
    Ellipticity expected{1e9, 1e9, -1e9};
    for (std::size_t i = 0; i < x.size(); ++i) {
        using Matrix = Eigen::Matrix3d;
        const auto vector = [](Vec3 v) { return Eigen::Vector3d(v.x, v.y, v.z); };
        const Eigen::Vector3d xi = vector(surface->places()[i]), g = vector(gradient[i]);
        Matrix sigma, differential;
        for (int c = 0; c < 9; ++c)
            sigma(c / 3, c % 3) = surface->sigma(workspace, i)[static_cast<std::size_t>(c)];
        const double h = 1e-5;
        for (int j = 0; j < 3; ++j) {
            const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(j);
            differential.col(j) =
                (slow::Surface::exponential(xi, g + step) - slow::Surface::exponential(xi, g - step)) /
                (2 * h);
        }
        const Matrix p = Matrix::Identity() - xi * xi.transpose();
        const Matrix a = sigma * p + vector(x[i]) * xi.transpose();
        const Matrix product = p * (a.determinant() * a.inverse()) * differential * p;
        // One of the three eigenvalues, for xi, is 0; the others are those in the tangent plane.
        const Eigen::Vector3d first = g.norm() > 0 ? g.normalized() : xi.unitOrthogonal();
        Eigen::Matrix<double, 3, 2> basis;
        basis << first, xi.cross(first);
        const Eigen::Matrix2d tangent = basis.transpose() * product * basis;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver((tangent + tangent.transpose()) / 2);
        expected.convexity = std::min(expected.convexity, solver.eigenvalues()[0]);
        expected.slowest = std::min(expected.slowest, m[i] * solver.eigenvalues()[0]);
        expected.fastest = std::max(expected.fastest, m[i] * solver.eigenvalues()[1]);
    }
    const Ellipticity found = equation.ellipticity();
    EXPECT_NEAR(found.convexity, expected.convexity, 1e-8);
    EXPECT_NEAR(found.slowest, expected.slowest, 1e-8);
    EXPECT_NEAR(found.fastest, expected.fastest, 1e-8);
    EXPECT_LT(found.convexity, 0.95);
}

TEST(SurfaceQ2, ZeroPotentialMovesNothing) {
    const SurfaceQ2 surface(sphere_setup({SphereCells::cubed, 4}, 2, 6371e3));
    auto workspace = surface.make_workspace();
    surface.map(std::vector<double>(surface.unknowns(), 0.0), workspace);
    Points x, gradient;
    surface.positions(workspace, x, gradient);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(x[i], surface.mesh()->nodes[i]);
}

TEST(SurfaceQ2, ApproachesTheAreaOfTheSphere) {
    double last = 1;
    for (const int k : {2, 4, 8}) {
        const double error =
            std::abs(SurfaceQ2(sphere_setup({SphereCells::cubed, k})).area() / (4 * std::numbers::pi) - 1);
        EXPECT_LT(error, last / 12); // fourth order
        last = error;
    }
}

TEST(SurfaceQ2, StopsOnRequestAndReportsProgress) {
    std::stop_source source;
    std::vector<double> told;
    const Progress progress = [&](double part, std::string_view) { told.push_back(part); };
    const SurfaceQ2 surface(sphere_setup({SphereCells::icosahedral, 2}), progress, source.get_token());
    EXPECT_GT(told.size(), 20u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    source.request_stop();
    EXPECT_THROW(SurfaceQ2(sphere_setup({SphereCells::icosahedral, 2}), progress, source.get_token()),
                 Interrupted);
}

} // namespace
} // namespace gaspard
