#include "core/spline/line_matrices.hpp"

namespace gaspard {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Rows: basis functions; columns: quadrature points.
MatrixXd dense(const LineTable& table, int derivative) {
    MatrixXd all = MatrixXd::Zero(static_cast<Index>(table.functions()), static_cast<Index>(table.points()));
    for (std::size_t q = 0; q < table.points(); ++q)
        for (std::size_t k = 0; k < table.width(); ++k)
            all(static_cast<Index>(table.first(q) + k), static_cast<Index>(q)) = table.row(derivative, q)[k];
    return all;
}

MatrixXd products(const SplineLine& line, const MatrixXd& a, const MatrixXd& b) {
    const Eigen::Map<const Eigen::VectorXd> w(line.weights.data(), static_cast<Index>(line.weights.size()));
    return a * w.asDiagonal() * b.transpose();
}

} // namespace

LineMatrices::LineMatrices(const SplineLine& line) {
    const SplineGrid grid(line, line.points);
    const MatrixXd b = dense(grid.upper, 0), slope = dense(grid.upper, 1), below = dense(grid.lower, 0);
    mass = products(line, b, b);
    stiffness = products(line, slope, slope);
    mass_below = products(line, below, below);
    r = products(line, slope, below);
}

LineOperator line_operator(const MatrixXd& symmetric) {
    const MatrixXd mean = (symmetric + symmetric.transpose()) / 2;
    return {static_cast<std::size_t>(mean.rows()), {mean.data(), mean.data() + mean.size()}};
}

std::vector<double> moments(const SplineLine& line, const LineTable& table, std::span<const double> values) {
    std::vector<double> sums(table.functions(), 0.0);
    for (std::size_t q = 0; q < table.points(); ++q)
        for (std::size_t k = 0; k < table.width(); ++k)
            sums[table.first(q) + k] += line.weights[q] * values[q] * table.row(0, q)[k];
    return sums;
}

template <>
std::vector<double> face_moments<2>(const SplineLine& line, const LineTable& table,
                                    std::span<const double> values) {
    return moments(line, table, values);
}

template <>
std::vector<double> face_moments<3>(const SplineLine& line, const LineTable& table,
                                    std::span<const double> values) {
    const std::size_t n = table.functions(), points = table.points();
    std::vector<double> sums(n * n, 0.0);
    for (std::size_t q = 0; q < points; ++q) {
        const std::vector<double> row = moments(line, table, values.subspan(q * points, points));
        for (std::size_t k = 0; k < table.width(); ++k)
            for (std::size_t i = 0; i < n; ++i)
                sums[(table.first(q) + k) * n + i] += line.weights[q] * table.row(0, q)[k] * row[i];
    }
    return sums;
}

std::vector<double> integrals(const SplineLine& line, const LineTable& table) {
    return moments(line, table, std::vector<double>(table.points(), 1.0));
}

} // namespace gaspard
