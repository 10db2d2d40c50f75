// Dense matrices for the reference computations. Factorisations are compiled once, in dense.cpp.
#pragma once

#include <Eigen/Core>

namespace gaspard::slow {

using Vector = Eigen::VectorXd;

/// x with a x = b, by LU with partial pivoting.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The same for a matrix with few entries that are not 0.
Eigen::MatrixXd solve_sparse(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The x with the smallest |a x - b|.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The upper triangular u with u^T u = a, which is symmetric and positive definite.
Eigen::MatrixXd cholesky(const Eigen::MatrixXd& a);
/// The lambda with a x = lambda b x, ascending; a and b are symmetric, b is positive definite.
Vector eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The largest absolute value of an entry.
inline double largest(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().maxCoeff(); }

} // namespace gaspard::slow
