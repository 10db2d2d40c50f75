#include "core/linear/dense.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>

namespace gaspard::slow {

using Eigen::MatrixXd;

MatrixXd solve(const MatrixXd& a, const MatrixXd& b) { return a.partialPivLu().solve(b); }

MatrixXd solve_sparse(const MatrixXd& a, const MatrixXd& b) {
    const Eigen::SparseMatrix<double> sparse = a.sparseView();
    return Eigen::SparseLU<Eigen::SparseMatrix<double>>(sparse).solve(b);
}

MatrixXd least_squares(const MatrixXd& a, const MatrixXd& b) { return a.colPivHouseholderQr().solve(b); }

MatrixXd cholesky(const MatrixXd& a) { return a.llt().matrixU(); }

Vector eigenvalues(const MatrixXd& a, const MatrixXd& b) {
    return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(a, b, Eigen::EigenvaluesOnly).eigenvalues();
}

} // namespace gaspard::slow
