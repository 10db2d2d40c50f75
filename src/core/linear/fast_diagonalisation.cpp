#include "core/linear/fast_diagonalisation.hpp"

#include "core/base/check.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using ConstMap = Eigen::Map<const MatrixXd>;
using Map = Eigen::Map<MatrixXd>;

ConstMap matrix(const LineOperator& of) {
    return {of.entries.data(), static_cast<Index>(of.size), static_cast<Index>(of.size)};
}

/// out = the matrix along one direction of the cube `in`.
template <class Matrix>
void apply_along(std::size_t direction, const Matrix& m, const double* in, double* out) {
    const Index n = m.rows(), plane = n * n;
    if (direction == 0) {
        Map(out, n, plane).noalias() = m * ConstMap(in, n, plane);
    } else if (direction == 1) {
        for (Index z = 0; z < n; ++z)
            Map(out + z * plane, n, n).noalias() = ConstMap(in + z * plane, n, n) * m.transpose();
    } else {
        Map(out, plane, n).noalias() = ConstMap(in, plane, n) * m.transpose();
    }
}

} // namespace

FastDiagonalisation::FastDiagonalisation(LineOperator stiffness, LineOperator mass, std::size_t dimension)
    : stiffness_(std::move(stiffness)), mass_(std::move(mass)), dimension_(dimension) {
    const std::size_t n = size();
    GASPARD_CHECK(dimension == 2 || dimension == 3);
    GASPARD_CHECK(n > 0 && mass_.size == n && stiffness_.entries.size() == n * n &&
                  mass_.entries.size() == n * n);
    const ConstMap m = matrix(mass_);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(matrix(stiffness_), m);
    GASPARD_CHECK(solver.info() == Eigen::Success);
    MatrixXd u = solver.eigenvectors();
    // The first eigenvector is constant up to rounding: make it exact, and the others M-orthogonal to it.
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Index>(n));
    const Eigen::VectorXd weights = m * ones;
    u.col(0) = ones / std::sqrt(weights.dot(ones));
    for (Index k = 1; k < u.cols(); ++k) u.col(k) -= ones * (weights.dot(u.col(k)) / weights.dot(ones));
    vectors_.assign(u.data(), u.data() + u.size());
    eigenvalues_.assign(solver.eigenvalues().data(), solver.eigenvalues().data() + n);
    eigenvalues_[0] = 0;
}

void FastDiagonalisation::solve(std::span<const double> b, std::span<double> x, double shift,
                                Workspace& workspace) const {
    GASPARD_CHECK(b.size() == unknowns() && x.size() == b.size());
    if (dimension_ == 2)
        solve_plane(b, x, shift, workspace);
    else
        solve_space(b, x, shift, workspace);
}

void FastDiagonalisation::solve_plane(std::span<const double> b, std::span<double> x, double shift,
                                      Workspace& workspace) const {
    const auto n = static_cast<Index>(size());
    const ConstMap u(vectors_.data(), n, n);
    Map first(workspace.first.data(), n, n), second(workspace.second.data(), n, n);
    first.noalias() = u.transpose() * ConstMap(b.data(), n, n);
    second.noalias() = first * u;
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i)
            second(i, j) /=
                eigenvalues_[static_cast<std::size_t>(i)] + eigenvalues_[static_cast<std::size_t>(j)] + shift;
    if (shift == 0) second(0, 0) = 0;
    first.noalias() = u * second;
    Map(x.data(), n, n).noalias() = first * u.transpose();
}

void FastDiagonalisation::solve_space(std::span<const double> b, std::span<double> x, double shift,
                                      Workspace& workspace) const {
    const std::size_t n = size();
    const ConstMap u(vectors_.data(), static_cast<Index>(n), static_cast<Index>(n));
    double *first = workspace.first.data(), *second = workspace.second.data();
    apply_along(0, u.transpose(), b.data(), first);
    apply_along(1, u.transpose(), first, second);
    apply_along(2, u.transpose(), second, first);
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t j = 0; j < n; ++j) {
            const double other = eigenvalues_[j] + eigenvalues_[k] + shift;
            double* line = first + (k * n + j) * n;
            for (std::size_t i = 0; i < n; ++i) line[i] /= eigenvalues_[i] + other;
        }
    if (shift == 0) first[0] = 0;
    apply_along(0, u, first, second);
    apply_along(1, u, second, first);
    apply_along(2, u, first, second);
    std::copy_n(second, x.size(), x.data());
}

void FastDiagonalisation::multiply(std::span<const double> x, std::span<double> y,
                                   Workspace& workspace) const {
    GASPARD_CHECK(x.size() == unknowns() && y.size() == x.size());
    const ConstMap k = matrix(stiffness_), m = matrix(mass_);
    if (dimension_ == 2) {
        const auto n = static_cast<Index>(size());
        const ConstMap in(x.data(), n, n);
        Map first(workspace.first.data(), n, n), second(workspace.second.data(), n, n), out(y.data(), n, n);
        first.noalias() = k * in;
        second.noalias() = first * m;
        first.noalias() = m * in;
        second.noalias() += first * k;
        out = second;
        return;
    }
    std::vector<double> sum(x.size(), 0.0);
    double *first = workspace.first.data(), *second = workspace.second.data();
    for (std::size_t direction = 0; direction < 3; ++direction) {
        apply_along(0, direction == 0 ? k : m, x.data(), first);
        apply_along(1, direction == 1 ? k : m, first, second);
        apply_along(2, direction == 2 ? k : m, second, first);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += first[i];
    }
    std::copy(sum.begin(), sum.end(), y.begin());
}

} // namespace gaspard
