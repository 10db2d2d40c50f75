// Means and derivatives of densities on triangles, beside integrals in closed form.
#include "core/layer/density_samples.hpp"

#include "core/base/error.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace gaspard {
namespace {

constexpr int n = 3;

/// Nodes and centres that form no regular pattern.
struct Crossed {
    Points nodes{16}, centres{9};
    Crossed() {
        for (std::size_t j = 0; j <= n; ++j)
            for (std::size_t i = 0; i <= n; ++i) {
                const auto x = static_cast<double>(i), y = static_cast<double>(j);
                nodes.set(4 * j + i, {x + 0.1 * y * y, y + 0.05 * x * y});
            }
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < n; ++i) {
                const std::size_t p = 4 * j + i;
                centres.set(3 * j + i, 0.25 * (nodes[p] + nodes[p + 1] + nodes[p + 4] + nodes[p + 5]) +
                                           Vec3{0.05, -0.03});
            }
    }
    std::array<Vec3, 3> corners(std::size_t q, std::size_t t) const {
        const std::size_t p = q / n * 4 + q % n;
        const std::array<Vec3, 5> of = {nodes[p], nodes[p + 1], nodes[p + 4], nodes[p + 5], centres[q]};
        return {of[crossed_triangles[t][0]], of[crossed_triangles[t][1]], of[crossed_triangles[t][2]]};
    }
};

/// m11 = 1 + x^2 y^2 of degree 4, m22 = 2 + x of degree 1.
void densities(const Points& at, std::span<double> m11, std::span<double> m22) {
    for (std::size_t i = 0; i < at.size(); ++i)
        m11[i] = 1 + at.x[i] * at.x[i] * at.y[i] * at.y[i], m22[i] = 2 + at.x[i];
}

/// The mean of x^2 y^2 over a triangle, from integrals of products of barycentric coordinates.
double mean_of_squares(const std::array<Vec3, 3>& c) {
    const auto factorial = [](int k) { return std::tgamma(k + 1.0); };
    double sum = 0;
    for (const std::size_t i : {0, 1, 2})
        for (const std::size_t j : {0, 1, 2})
            for (const std::size_t k : {0, 1, 2})
                for (const std::size_t l : {0, 1, 2}) {
                    std::array<int, 3> power{};
                    for (const std::size_t which : {i, j, k, l}) ++power[which];
                    const double integral =
                        2 * factorial(power[0]) * factorial(power[1]) * factorial(power[2]) / factorial(6);
                    sum += c[i].x * c[j].x * c[k].y * c[l].y * integral;
                }
    return sum;
}

TEST(DensitySampler, MeansOfPolynomialsOfDegree4AreExact) {
    const Crossed mesh;
    std::array<std::vector<double>, 2> means;
    DensitySampler(n, DensitySamples::degree_4).means(densities, mesh.nodes, mesh.centres, means);
    for (std::size_t q = 0; q < 9; ++q)
        for (std::size_t t = 0; t < 4; ++t) {
            const auto c = mesh.corners(q, t);
            EXPECT_NEAR(means[0][4 * q + t], 1 + mean_of_squares(c), 1e-12) << q << ' ' << t;
            EXPECT_NEAR(means[1][4 * q + t], 2 + (c[0].x + c[1].x + c[2].x) / 3, 1e-13) << q << ' ' << t;
        }
}

TEST(DensitySampler, CornersGiveTheMeansOfTheirValues) {
    const Crossed mesh;
    std::array<std::vector<double>, 2> means;
    DensitySampler(n, DensitySamples::corners).means(densities, mesh.nodes, mesh.centres, means);
    for (std::size_t q = 0; q < 9; ++q)
        for (std::size_t t = 0; t < 4; ++t) {
            double mean = 0;
            for (const Vec3 c : mesh.corners(q, t)) mean += (1 + c.x * c.x * c.y * c.y) / 3;
            EXPECT_NEAR(means[0][4 * q + t], mean, 1e-12) << q << ' ' << t;
        }
}

TEST(DensitySampler, DerivativesAreThoseOfTheMeans) {
    for (const auto samples : {DensitySamples::corners, DensitySamples::degree_4}) {
        Crossed mesh;
        const DensitySampler sampler(n, samples);
        const auto derivatives = sampler.derivatives(densities, mesh.nodes, mesh.centres, {1.5, 1.5});
        constexpr std::size_t q = 4; // in the middle; its centre is corner 2 of its triangles
        for (const std::size_t coordinate : {0, 1}) {
            std::array<std::array<std::vector<double>, 2>, 2> moved;
            constexpr double step = 1e-5;
            double& x = coordinate == 0 ? mesh.centres.x[q] : mesh.centres.y[q];
            const double kept = x;
            x = kept - step;
            sampler.means(densities, mesh.nodes, mesh.centres, moved[0]);
            x = kept + step;
            sampler.means(densities, mesh.nodes, mesh.centres, moved[1]);
            x = kept;
            for (const std::size_t axis : {0, 1})
                for (std::size_t t = 0; t < 4; ++t) {
                    const double slope =
                        (moved[1][axis][4 * q + t] - moved[0][axis][4 * q + t]) / (2 * step);
                    EXPECT_NEAR(derivatives[axis][coordinate][4 * q + t][2], slope,
                                1e-3 * (1 + std::abs(slope)))
                        << axis << ' ' << t;
                }
        }
    }
}

TEST(DensitySampler, RefusesADensityThatIsNotPositive) {
    const Crossed mesh;
    std::array<std::vector<double>, 2> means;
    for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
        try {
            DensitySampler(n, DensitySamples::corners)
                .means(
                    [&](const Points& at, std::span<double> m11, std::span<double> m22) {
                        for (std::size_t i = 0; i < at.size(); ++i)
                            m11[i] = 1, m22[i] = at.y[i] > 2.9 ? bad : 1;
                    },
                    mesh.nodes, mesh.centres, means);
            FAIL() << bad;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("must be positive and finite"), std::string::npos);
        }
}

} // namespace
} // namespace gaspard
