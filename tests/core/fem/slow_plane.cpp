#include "core/fem/slow_plane.hpp"

namespace gaspard::slow {

void Plane::for_each_place(const std::function<void(const Place&)>& action) const {
    const int points = static_cast<int>(rule_.points.size());
    for (int j = 0; j < n_; ++j)
        for (int i = 0; i < n_; ++i)
            for (int q = 0; q < points; ++q)
                for (int p = 0; p < points; ++p) action({i, j, p, q, weight(p, q)});
}

Vector Plane::load(int degree, const std::function<double(const Jet& v, const Place&)>& integrand) const {
    Vector b = Vector::Zero(unknowns(degree));
    for_each_place([&](const Place& place) {
        for (int l = 0; l <= degree; ++l)
            for (int k = 0; k <= degree; ++k)
                b[unknown(degree, place.i, place.j, k, l)] +=
                    place.weight * integrand(basis(degree, k, l, place.p, place.q), place);
    });
    return b;
}

Eigen::MatrixXd Plane::matrix(int degree, const Form& form) const {
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

Vector Plane::project(int degree, Vector b, Vanish vanish) const {
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
    return solve_sparse(m, b);
}

Jet Plane::at(int degree, const Vector& f, const Place& place) const {
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

} // namespace gaspard::slow
