// Reference: Lagrange elements on n x n squares of the unit square with two-dimensional basis functions,
// sparse matrices and overintegration, written from the formulas alone. PlaneQ2 is compared with it.
//
// A function of degree k has its values on the lattice (i / (k n), j / (k n)), x fastest; on the
// periodic square the last row and column coincide with the first.
#pragma once

#include "core/linear/slow_line.hpp"

#include <functional>
#include <vector>

namespace gaspard::slow {

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

    Jet at(int degree, const Vector& f, const Place& place) const;

    void for_each_place(const std::function<void(const Place&)>& action) const;

    /// The integrals of `integrand` against every test function v.
    Vector load(int degree, const std::function<double(const Jet& v, const Place&)>& integrand) const;

    using Form = std::function<double(const Jet& v, const Jet& u)>;
    Eigen::MatrixXd matrix(int degree, const Form& form) const;

    /// The f with <v, f> = b_v for all v that vanish where f does.
    Vector project(int degree, Vector b, Vanish vanish = {}) const;

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

} // namespace gaspard::slow
