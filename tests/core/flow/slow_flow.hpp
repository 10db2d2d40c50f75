// Quasi-geostrophic flow without any of the structure that QuasiGeostrophicFlow uses: triangles with their
// corners and neighbours, quadrature, dense matrices.
#pragma once

#include "core/flow/flow_options.hpp"
#include "core/linear/dense.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace gaspard::slow {

class Flow {
  public:
    explicit Flow(const FlowOptions& options) : n_(options.cells), options_(options) {
        const auto n = static_cast<Eigen::Index>(n_ * n_);
        stiffness_ = mass_ = Eigen::MatrixXd::Zero(n, n);
        for (std::size_t t = 0; t < triangles(); ++t)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) {
                    const auto [ax, ay] = gradient(t, k);
                    const auto [bx, by] = gradient(t, l);
                    stiffness_(node(t, k), node(t, l)) += area() * (ax * bx + ay * by);
                    mass_(node(t, k), node(t, l)) += area() / (k == l ? 6 : 12);
                }
    }

    /// (v, q) for the shape functions of the nodes.
    Vector load(const std::vector<double>& q) const {
        Vector b = Vector::Zero(mass_.rows());
        for (std::size_t t = 0; t < triangles(); ++t)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) b[node(t, k)] += area() / (k == l ? 6 : 12) * q[place(t, l)];
        return b;
    }
    Vector psi(const std::vector<double>& q) const {
        return solve(stiffness_ + options_.froude * mass_, -load(q));
    }
    Vector projection(const std::vector<double>& q) const { return solve(mass_, load(q)); }
    double energy(const std::vector<double>& q) const {
        const Vector p = psi(q);
        return 0.5 * p.dot((stiffness_ + options_.froude * mass_) * p);
    }

    /// q + dt L(q).
    std::vector<double> euler(const std::vector<double>& q, double dt) const {
        const Vector p = psi(q);
        std::vector<double> next = q;
        for (std::size_t t = 0; t < triangles(); ++t) {
            double ux = options_.background[0], uy = options_.background[1];
            for (int k = 0; k < 3; ++k) {
                const auto [gx, gy] = gradient(t, k);
                ux -= p[node(t, k)] * gy, uy += p[node(t, k)] * gx;
            }
            Vector r = Vector::Zero(3);
            const double mean = (q[place(t, 0)] + q[place(t, 1)] + q[place(t, 2)]) / 3;
            for (int k = 0; k < 3; ++k) {
                const auto [gx, gy] = gradient(t, k);
                r[k] += area() * mean * (ux * gx + uy * gy);
            }
            for (int k = 0; k < 3; ++k) add_edge(q, t, k, ux, uy, r);
            Eigen::MatrixXd local = Eigen::MatrixXd::Constant(3, 3, area() / 12);
            for (int k = 0; k < 3; ++k) local(k, k) = area() / 6;
            const Vector rate = solve(local, r);
            for (int k = 0; k < 3; ++k) next[place(t, k)] += dt * rate[k];
        }
        return next;
    }
    /// A step of the method of Shu and Osher.
    std::vector<double> step(const std::vector<double>& q, double dt) const {
        const std::vector<double> first = euler(q, dt);
        std::vector<double> second = euler(first, dt);
        for (std::size_t i = 0; i < q.size(); ++i) second[i] = 0.75 * q[i] + 0.25 * second[i];
        std::vector<double> third = euler(second, dt);
        for (std::size_t i = 0; i < q.size(); ++i) third[i] = (q[i] + 2 * third[i]) / 3;
        return third;
    }

  private:
    std::size_t triangles() const { return 2 * n_ * n_; }
    double area() const { return 0.5 / static_cast<double>(n_ * n_); }
    /// Corners of a triangle in the square (i, j): lower right of the diagonal, then upper left.
    static std::array<int, 2> corner(std::size_t t, int k) {
        constexpr std::array<std::array<int, 2>, 6> all{{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}};
        return all[3 * (t % 2) + static_cast<std::size_t>(k)];
    }
    std::array<std::size_t, 2> square(std::size_t t) const { return {t / 2 % n_, t / 2 / n_}; }
    Eigen::Index node(std::size_t t, int k) const {
        const auto [i, j] = square(t);
        const auto [x, y] = corner(t, k);
        return static_cast<Eigen::Index>((j + static_cast<std::size_t>(y)) % n_ * n_ +
                                         (i + static_cast<std::size_t>(x)) % n_);
    }
    /// In a state of QuasiGeostrophicFlow.
    std::size_t place(std::size_t t, int k) const {
        return (3 * (t % 2) + static_cast<std::size_t>(k)) * n_ * n_ + t / 2;
    }
    /// Of the shape function of a corner.
    std::array<double, 2> gradient(std::size_t t, int k) const {
        const auto a = corner(t, (k + 1) % 3), b = corner(t, (k + 2) % 3);
        const auto n = static_cast<double>(n_);
        return {n * (a[1] - b[1]), n * (b[0] - a[0])};
    }
    /// The triangle beyond the edge opposite to a corner: it has the same two nodes and is another one.
    std::size_t neighbour(std::size_t t, int k) const {
        const Eigen::Index a = node(t, (k + 1) % 3), b = node(t, (k + 2) % 3);
        for (std::size_t other = 0; other < triangles(); ++other) {
            int shared = 0;
            for (int l = 0; l < 3; ++l) shared += node(other, l) == a || node(other, l) == b ? 1 : 0;
            if (other != t && shared == 2) return other;
        }
        return t;
    }
    int corner_at(std::size_t t, Eigen::Index wanted) const {
        for (int k = 0; k < 3; ++k)
            if (node(t, k) == wanted) return k;
        return 0;
    }
    /// Subtracts <v, q_upwind u . n> by Gauss's rule with two points.
    void add_edge(const std::vector<double>& q, std::size_t t, int k, double ux, double uy, Vector& r) const {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        const auto from = corner(t, a), to = corner(t, b);
        const double h = 1 / static_cast<double>(n_);
        const double flux = h * (ux * (to[1] - from[1]) - uy * (to[0] - from[0])); // times the length
        const std::size_t other = flux > 0 ? t : neighbour(t, k);
        const double qa = q[place(other, corner_at(other, node(t, a)))],
                     qb = q[place(other, corner_at(other, node(t, b)))];
        for (const double s : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)}) {
            const double value = 0.5 * flux * ((1 - s) * qa + s * qb);
            r[a] -= (1 - s) * value;
            r[b] -= s * value;
        }
    }

    std::size_t n_;
    FlowOptions options_;
    Eigen::MatrixXd stiffness_, mass_;
};

} // namespace gaspard::slow
