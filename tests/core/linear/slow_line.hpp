// Reference: dense matrices of Lagrange elements on [0, 1] with n equal cells, from exactly integrated
// polynomials. The fast operators along lines are compared with it.
#pragma once

#include "core/linear/dense.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gaspard::slow {

using Polynomial = std::vector<long double>; ///< coefficients of 1, s, s^2, ...

inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial result(a.size() + b.size() - 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
    return result;
}

inline Polynomial derivative(const Polynomial& p) {
    Polynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) result.push_back(static_cast<long double>(i) * p[i]);
    return result;
}

/// Over [0,1].
inline long double integral(const Polynomial& p) {
    long double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] / static_cast<long double>(i + 1);
    return sum;
}

inline double evaluate(const Polynomial& p, double s) {
    long double sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * s + p[i];
    return static_cast<double>(sum);
}

/// 1 at node / degree, 0 at the other multiples of 1 / degree.
inline Polynomial lagrange(int degree, int node) {
    Polynomial p{1};
    for (int other = 0; other <= degree; ++other)
        if (other != node) {
            const long double gap = static_cast<long double>(node - other) / degree;
            p = p * Polynomial{-(static_cast<long double>(other) / degree) / gap, 1 / gap};
        }
    return p;
}

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
inline Eigen::MatrixXd line_matrix(Line line, Factor test, Factor trial) {
    const long double h = 1.0L / line.cells;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(line.unknowns(test.degree), line.unknowns(trial.degree));
    for (int cell = 0; cell < line.cells; ++cell)
        for (int i = 0; i <= test.degree; ++i)
            for (int j = 0; j <= trial.degree; ++j) {
                Polynomial v = lagrange(test.degree, i), u = lagrange(trial.degree, j);
                if (test.derive) v = derivative(v);
                if (trial.derive) u = derivative(u);
                const int derivatives = (test.derive ? 1 : 0) + (trial.derive ? 1 : 0);
                matrix(line.unknown(test.degree, cell, i), line.unknown(trial.degree, cell, j)) +=
                    static_cast<double>(integral(v * u) * std::pow(h, 1 - derivatives));
            }
    return matrix;
}

inline Eigen::MatrixXd mass(Line line, int degree) { return line_matrix(line, {degree}, {degree}); }
inline Eigen::MatrixXd stiffness(Line line, int degree) {
    return line_matrix(line, {degree, true}, {degree, true});
}

/// The largest absolute value of an entry.
inline double largest(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().maxCoeff(); }

} // namespace gaspard::slow
