// Reference: dense matrices of Lagrange elements on [0, 1] with n equal cells, from exactly integrated
// polynomials. The fast operators along lines are compared with it.
#pragma once

#include "core/linear/dense.hpp"
#include "support/polynomials.hpp"

namespace gaspard::slow {

struct Line {
    int cells;
    bool periodic; ///< otherwise natural boundary conditions

    int unknowns(int degree) const { return cells * degree + (periodic ? 0 : 1); }
    /// Unknowns are numbered from left to right; local node 0 is the left end of the cell.
    int unknown(int degree, int cell, int local) const { return (cell * degree + local) % unknowns(degree); }
};

struct Factor { ///< one side of a bilinear form: a space, and whether its functions are differentiated
    int degree;
    bool derive = false;
};

/// Integrals of test times trial; rows are test functions.
Eigen::MatrixXd line_matrix(Line line, Factor test, Factor trial);

inline Eigen::MatrixXd mass(Line line, int degree) { return line_matrix(line, {degree}, {degree}); }
inline Eigen::MatrixXd stiffness(Line line, int degree) {
    return line_matrix(line, {degree, true}, {degree, true});
}

} // namespace gaspard::slow
