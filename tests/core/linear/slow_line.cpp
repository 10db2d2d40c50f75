#include "core/linear/slow_line.hpp"

#include <cmath>

namespace gaspard::slow {

Eigen::MatrixXd line_matrix(Line line, Factor test, Factor trial) {
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

} // namespace gaspard::slow
