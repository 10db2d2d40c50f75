#include "core/linear/fast_diagonalisation.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr std::size_t n = 9;

/// Linear elements on unequal cells.
struct Line {
    Line() {
        const auto add = [](LineOperator& to, std::size_t i, std::size_t j, double value) {
            to.entries[i * n + j] += value;
        };
        for (std::size_t c = 0; c + 1 < n; ++c) {
            const double h = 0.05 + 0.02 * static_cast<double>(c);
            for (std::size_t a = 0; a < 2; ++a)
                for (std::size_t b = 0; b < 2; ++b) {
                    add(stiffness, c + a, c + b, (a == b ? 1 : -1) / h);
                    add(mass, c + a, c + b, (a == b ? 2 : 1) * h / 6);
                }
        }
    }
    LineOperator stiffness{n, std::vector<double>(n*n, 0.0)}, mass = stiffness;
};

std::vector<double> numbers() {
    std::vector<double> b(n * n);
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(3.7 * static_cast<double>(i * i));
    return b;
}

TEST(FastDiagonalisation, SolvesWithAShift) {
    const Line line;
    const FastDiagonalisation solver(line.stiffness, line.mass);
    auto workspace = solver.make_workspace();
    const auto b = numbers();
    std::vector<double> x(b), y(b);
    solver.solve(b, x, 0.3, workspace);
    // Entrywise, from the definition of the Kronecker product.
    for (std::size_t row = 0; row < n * n; ++row) {
        double sum = 0;
        for (std::size_t column = 0; column < n * n; ++column) {
            const std::size_t i = row % n * n + column % n, j = row / n * n + column / n;
            sum += (line.stiffness.entries[i] * line.mass.entries[j] +
                    line.mass.entries[i] * line.stiffness.entries[j] +
                    0.3 * line.mass.entries[i] * line.mass.entries[j]) *
                   x[column];
        }
        EXPECT_NEAR(sum, b[row], 1e-10);
    }
}

TEST(FastDiagonalisation, SolvesInThreeDirections) {
    const Line line;
    const FastDiagonalisation solver(line.stiffness, line.mass, 3);
    auto workspace = solver.make_workspace();
    std::vector<double> b(n * n * n), x(b), y(b);
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(3.7 * static_cast<double>(i * i));
    solver.solve(b, x, 0.3, workspace);
    const auto &k = line.stiffness.entries, &m = line.mass.entries;
    solver.multiply(x, y, workspace);
    for (std::size_t row = 0; row < b.size(); row += 5) { // entrywise
        double sum = 0, with_shift = 0;
        for (std::size_t column = 0; column < b.size(); ++column) {
            const std::size_t i1 = row % n * n + column % n, i2 = row / n % n * n + column / n % n,
                              i3 = row / n / n * n + column / n / n;
            sum += (k[i1] * m[i2] * m[i3] + m[i1] * k[i2] * m[i3] + m[i1] * m[i2] * k[i3]) * x[column];
            with_shift += 0.3 * m[i1] * m[i2] * m[i3] * x[column];
        }
        EXPECT_NEAR(y[row], sum, 1e-10);
        EXPECT_NEAR(sum + with_shift, b[row], 1e-9);
    }
}

TEST(FastDiagonalisation, DropsTheConstantExactly) {
    const Line line;
    const FastDiagonalisation solver(line.stiffness, line.mass);
    EXPECT_EQ(solver.eigenvalues()[0], 0);
    auto workspace = solver.make_workspace();
    auto b = numbers();
    double sum = 0;
    for (const double value : b) sum += value;
    for (double& value : b) value -= sum / (n * n); // against the function 1
    std::vector<double> x(b), again(b), shifted(b), y(b);
    solver.solve(b, x, 0, workspace);
    solver.multiply(x, again, workspace);
    for (std::size_t i = 0; i < b.size(); ++i) EXPECT_NEAR(again[i], b[i], 1e-11);
    // Adding a constant to b changes nothing.
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            double mi = 0, mj = 0;
            for (std::size_t k = 0; k < n; ++k)
                mi += line.mass.entries[i * n + k], mj += line.mass.entries[j * n + k];
            b[j * n + i] += 1000 * mi * mj;
        }
    solver.solve(b, shifted, 0, workspace);
    for (std::size_t i = 0; i < b.size(); ++i) EXPECT_NEAR(shifted[i], x[i], 1e-12 * 1000);
}

} // namespace
} // namespace gaspard
