#include "core/linear/fast_diagonalisation.hpp"

#include "core/base/check.hpp"

#include <Eigen/Dense>
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

} // namespace

FastDiagonalisation::FastDiagonalisation(LineOperator stiffness, LineOperator mass)
    : stiffness_(std::move(stiffness)), mass_(std::move(mass)) {
    const std::size_t n = size();
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
    const auto n = static_cast<Index>(size());
    GASPARD_CHECK(b.size() == size() * size() && x.size() == b.size());
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

void FastDiagonalisation::multiply(std::span<const double> x, std::span<double> y,
                                   Workspace& workspace) const {
    const auto n = static_cast<Index>(size());
    GASPARD_CHECK(x.size() == size() * size() && y.size() == x.size());
    const ConstMap in(x.data(), n, n), k = matrix(stiffness_), m = matrix(mass_);
    Map first(workspace.first.data(), n, n), second(workspace.second.data(), n, n), out(y.data(), n, n);
    first.noalias() = k * in;
    second.noalias() = first * m;
    first.noalias() = m * in;
    second.noalias() += first * k;
    out = second;
}

} // namespace gaspard
