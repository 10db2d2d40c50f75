// Reference: Lagrange elements on n x n squares of the unit square with two-dimensional basis functions,
// sparse matrices and overintegration, written from the formulas alone. PlaneQ2 is compared with it.
//
// A function of degree k has its values on the lattice (i / (k n), j / (k n)), x fastest; on the
// periodic square the last row and column coincide with the first.
#pragma once

#include "core/linear/slow_line.hpp"

#include <functional>
#include <random>

namespace gaspard::slow {

using Vector = Eigen::VectorXd;

struct Rule {
    std::vector<double> points, weights;
};

/// Gauss-Legendre on [0,1] from the eigenvectors of the Jacobi matrix (Golub and Welsch).
inline Rule gauss(int count) {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(count, count);
    for (int k = 1; k < count; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
    Rule rule;
    for (int k = 0; k < count; ++k) {
        rule.points.push_back((1 + solver.eigenvalues()[k]) / 2);
        rule.weights.push_back(solver.eigenvectors()(0, k) * solver.eigenvectors()(0, k));
    }
    return rule;
}

/// A function at a point: value and derivatives.
struct Jet {
    double value = 0, dx = 0, dy = 0;
};

/// A quadrature point: cell (i, j), point (p, q) of the rule, weight times the cell's area.
struct Place {
    int i, j, p, q;
    double weight;
};

/// Whether values vanish on the walls x = 0, 1 and y = 0, 1.
struct Vanish {
    bool on_x = false, on_y = false;
};

class Plane {
  public:
    Plane(int cells, bool periodic) : n_(cells), periodic_(periodic), rule_(gauss(6)) {
        for (const int degree : {1, 2})
            for (int a = 0; a <= degree; ++a)
                for (const double s : rule_.points)
                    lines_[degree][a].push_back(
                        {evaluate(lagrange(degree, a), s), evaluate(derivative(lagrange(degree, a)), s)});
    }

    int side(int degree) const { return degree * n_ + (periodic_ ? 0 : 1); }
    int unknowns(int degree) const { return side(degree) * side(degree); }
    /// Index of node (a, b) of cell (i, j), each from 0 to degree.
    int unknown(int degree, int i, int j, int a, int b) const {
        return (degree * j + b) % side(degree) * side(degree) + (degree * i + a) % side(degree);
    }

    /// The function that is 1 at node (a, b) of a cell.
    Jet basis(int degree, int a, int b, int p, int q) const {
        const Local x = lines_[degree][a][static_cast<std::size_t>(p)];
        const Local y = lines_[degree][b][static_cast<std::size_t>(q)];
        return {x.value * y.value, n_ * x.slope * y.value, n_ * x.value * y.slope};
    }

    Jet at(int degree, const Vector& f, const Place& place) const {
        Jet sum;
        for (int b = 0; b <= degree; ++b)
            for (int a = 0; a <= degree; ++a) {
                const Jet shape = basis(degree, a, b, place.p, place.q);
                const double value = f[unknown(degree, place.i, place.j, a, b)];
                sum.value += value * shape.value;
                sum.dx += value * shape.dx;
                sum.dy += value * shape.dy;
            }
        return sum;
    }

    void for_each_place(const std::function<void(const Place&)>& action) const {
        const int points = static_cast<int>(rule_.points.size());
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i)
                for (int q = 0; q < points; ++q)
                    for (int p = 0; p < points; ++p) action({i, j, p, q, weight(p, q)});
    }

    /// The integrals of `integrand` against every test function v.
    Vector load(int degree, const std::function<double(const Jet& v, const Place&)>& integrand) const {
        Vector b = Vector::Zero(unknowns(degree));
        for_each_place([&](const Place& place) {
            for (int l = 0; l <= degree; ++l)
                for (int k = 0; k <= degree; ++k)
                    b[unknown(degree, place.i, place.j, k, l)] +=
                        place.weight * integrand(basis(degree, k, l, place.p, place.q), place);
        });
        return b;
    }

    using Form = std::function<double(const Jet& v, const Jet& u)>;
    Eigen::MatrixXd matrix(int degree, const Form& form) const {
        Eigen::MatrixXd m = Eigen::MatrixXd::Zero(unknowns(degree), unknowns(degree));
        const int locals = degree + 1;
        Eigen::MatrixXd local = Eigen::MatrixXd::Zero(locals * locals, locals * locals);
        const int points = static_cast<int>(rule_.points.size());
        for (int q = 0; q < points; ++q) // every cell has the same local matrix
            for (int p = 0; p < points; ++p)
                for (int v = 0; v < locals * locals; ++v)
                    for (int u = 0; u < locals * locals; ++u)
                        local(v, u) += weight(p, q) * form(basis(degree, v % locals, v / locals, p, q),
                                                           basis(degree, u % locals, u / locals, p, q));
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i)
                for (int v = 0; v < locals * locals; ++v)
                    for (int u = 0; u < locals * locals; ++u)
                        m(unknown(degree, i, j, v % locals, v / locals),
                          unknown(degree, i, j, u % locals, u / locals)) += local(v, u);
        return m;
    }

    /// The f with <v, f> = b_v for all v that vanish where f does.
    Vector project(int degree, Vector b, Vanish vanish = {}) const {
        Eigen::MatrixXd m = matrix(degree, [](const Jet& v, const Jet& u) { return v.value * u.value; });
        const int last = side(degree) - 1;
        for (int j = 0; j <= last && !periodic_; ++j)
            for (int i = 0; i <= last; ++i)
                if ((vanish.on_x && (i == 0 || i == last)) || (vanish.on_y && (j == 0 || j == last))) {
                    const int k = j * (last + 1) + i;
                    m.row(k).setZero();
                    m(k, k) = 1;
                    b[k] = 0;
                }
        const Eigen::SparseMatrix<double> sparse = m.sparseView();
        return Eigen::SparseLU<Eigen::SparseMatrix<double>>(sparse).solve(b);
    }

  private:
    struct Local {
        double value, slope;
    };
    double weight(int p, int q) const {
        return rule_.weights[static_cast<std::size_t>(p)] * rule_.weights[static_cast<std::size_t>(q)] /
               (n_ * n_);
    }

    int n_;
    bool periodic_;
    Rule rule_;
    std::vector<Local> lines_[3][3]; ///< of degree and node: at the points of the rule
};

/// `count` deterministic pseudo-random numbers between low and high.
inline std::vector<double> random_values(std::size_t count, double low, double high, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> distribution(low, high);
    std::vector<double> values(count);
    for (double& value : values) value = distribution(random);
    return values;
}

} // namespace gaspard::slow
