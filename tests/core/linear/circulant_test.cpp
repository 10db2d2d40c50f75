#include "core/linear/circulant.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

std::vector<double> random_plane(std::size_t n) {
    std::mt19937 random(static_cast<unsigned>(n));
    std::uniform_real_distribution<double> distribution(-1, 1);
    std::vector<double> values(n * n);
    for (double& value : values) value = distribution(random);
    return values;
}

class Circulant : public testing::TestWithParam<std::size_t> {};
// Fewer and more rows than a batch, whole and partial ones, even and odd.
INSTANTIATE_TEST_SUITE_P(Sizes, Circulant, testing::Values(1, 2, 3, 5, 8, 15, 16, 17, 24, 25, 40));

// A stencil that is symmetric under reflections through a point, but in neither direction alone.
TEST_P(Circulant, AppliesAStencil) {
    const std::size_t n = GetParam();
    CirculantTransform transform(n);
    const auto factors = transform.factors(
        [](double a, double b) { return 2 + 0.5 * std::cos(a) + 0.25 * std::cos(b) + std::cos(a + 2 * b); });
    const std::vector<double> in = random_plane(n);
    std::vector<double> out(n * n);
    transform.apply(factors, in, out);
    const auto at = [&](std::size_t i, std::size_t j) { return in[j % n * n + i % n]; };
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t x = i + n, y = j + 2 * n;
            const double expected = 2 * at(x, y) + 0.25 * (at(x + 1, y) + at(x - 1, y)) +
                                    0.125 * (at(x, y + 1) + at(x, y - 1)) +
                                    0.5 * (at(x + 1, y + 2) + at(x - 1, y - 2));
            EXPECT_NEAR(out[j * n + i], expected, 1e-14) << i << ", " << j;
        }
}

TEST_P(Circulant, IsInvertedInPlace) {
    const std::size_t n = GetParam();
    CirculantTransform transform(n);
    const auto symbol = [](double a, double b) { return 3 + std::cos(a) + std::cos(a - b); };
    const std::vector<double> in = random_plane(n);
    std::vector<double> values = in;
    transform.apply(transform.factors(symbol), values, values);
    transform.apply(transform.factors([&](double a, double b) { return 1 / symbol(a, b); }), values, values);
    for (std::size_t i = 0; i < in.size(); ++i) EXPECT_NEAR(values[i], in[i], 1e-14);
}

} // namespace
} // namespace gaspard
