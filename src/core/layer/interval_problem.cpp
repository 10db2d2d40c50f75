#include "core/layer/interval_problem.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// Gauss's rule with five points on [0, 1].
constexpr std::array<double, 5> gauss_at = {0.046910077030668004, 0.23076534494715845, 0.5,
                                            0.76923465505284155, 0.95308992296933200};
constexpr std::array<double, 5> gauss_weight = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                                0.23931433524968324, 0.11846344252809454};

/// Shape functions at s in [0, 1] and their derivatives by s: left, right and, of order 2, middle.
struct Shape {
    std::array<double, 3> value, slope;
};
Shape shape(int order, double s) {
    if (order == 1) return {{1 - s, s, 0}, {-1, 1, 0}};
    return {{(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)}, {4 * s - 3, 4 * s - 1, 4 - 8 * s}};
}

template <int m>
struct Element {
    using Matrix = Eigen::Matrix<double, m, m>;
    using Vector = Eigen::Matrix<double, m, 1>;
    std::array<std::array<Matrix, 3>, 3> a;
    std::array<Vector, 3> b;

    Element() {
        for (auto& row : a)
            for (Matrix& block : row) block.setZero();
        for (Vector& block : b) block.setZero();
    }
};

template <int m>
Element<m> element(const IntervalProblem& problem, const IntervalCoefficients& at, std::size_t cell, double h,
                   int order) {
    Element<m> e;
    const int count = order + 1;
    for (std::size_t g = 0; g < gauss_at.size(); ++g) {
        const std::size_t point = cell * gauss_at.size() + g;
        const double* convection = at.convection.data() + point * m;
        const double* reaction = at.reaction.data() + point * m * m;
        const double* source = at.source.data() + point * m;
        const Shape phi = shape(order, gauss_at[g]);
        const double w = gauss_weight[g];
        for (int i = 0; i < count; ++i) {
            const double vi = phi.value[static_cast<std::size_t>(i)],
                         di = phi.slope[static_cast<std::size_t>(i)];
            for (int k = 0; k < m; ++k) e.b[static_cast<std::size_t>(i)](k) += w * h * vi * source[k];
            for (int j = 0; j < count; ++j) {
                const double vj = phi.value[static_cast<std::size_t>(j)],
                             dj = phi.slope[static_cast<std::size_t>(j)];
                auto& block = e.a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
                for (int k = 0; k < m; ++k) {
                    const double added = at.added_diffusion.empty() ? 0 : at.added_diffusion[cell * m + k];
                    const double diffusion = problem.diffusion[static_cast<std::size_t>(k)] + added;
                    block(k, k) += w * (diffusion / h * di * dj + convection[k] * vi * dj);
                    for (int l = 0; l < m; ++l) block(k, l) += w * h * reaction[k * m + l] * vi * vj;
                }
            }
        }
    }
    return e;
}

/// The unknown in the middle in terms of those at the ends: u_C = c - D_0 u_left - D_1 u_right.
template <int m>
struct Middle {
    typename Element<m>::Vector c;
    std::array<typename Element<m>::Matrix, 2> d;
};

/// Eliminates the unknown in the middle of an element of order 2.
template <int m>
Middle<m> condense(Element<m>& e) {
    const typename Element<m>::Matrix inverse = e.a[2][2].inverse();
    Middle<m> middle{inverse * e.b[2], {inverse * e.a[2][0], inverse * e.a[2][1]}};
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) e.a[i][j] -= e.a[i][2] * middle.d[j];
        e.b[i] -= e.a[i][2] * middle.c;
    }
    return middle;
}

/// Block elimination along the interval; the pivots are definite for these problems, also without diffusion.
template <int m>
IntervalSolution solve(const IntervalProblem& problem, const IntervalCoefficients& at,
                       std::span<const double> x, int order) {
    using Matrix = typename Element<m>::Matrix;
    using Vector = typename Element<m>::Vector;
    const std::size_t n = x.size() - 1;
    std::vector<Matrix> upper(n + 1, Matrix::Zero());
    std::vector<Vector> u(n + 1, Vector::Zero());
    std::vector<Middle<m>> middles(order == 2 ? n : 0);
    Element<m> before;
    for (std::size_t i = 0; i < n; ++i) { // rows of node i: from the cells before and after it
        Element<m> e = element<m>(problem, at, i, x[i + 1] - x[i], order);
        if (order == 2) middles[i] = condense(e);
        if (i > 0) {
            const Matrix pivot = before.a[1][1] + e.a[0][0] - before.a[1][0] * upper[i - 1];
            const Eigen::PartialPivLU<Matrix> lu(pivot);
            upper[i] = lu.solve(e.a[0][1]);
            u[i] = lu.solve(before.b[1] + e.b[0] - before.a[1][0] * u[i - 1]);
        }
        before = e;
    }
    u[n].setZero();
    for (std::size_t i = n; i-- > 1;) u[i] -= upper[i] * u[i + 1];
    IntervalSolution solution{order, {}, {}};
    for (int k = 0; k < m; ++k) {
        auto& nodes = solution.nodes.emplace_back(n + 1);
        for (std::size_t i = 0; i <= n; ++i) nodes[i] = u[i](k);
        if (order == 1) continue;
        auto& mids = solution.middles.emplace_back(n);
        for (std::size_t i = 0; i < n; ++i)
            mids[i] = (middles[i].c - middles[i].d[0] * u[i] - middles[i].d[1] * u[i + 1])(k);
    }
    return solution;
}

} // namespace

IntervalCoefficients coefficients_at(const IntervalProblem& problem, std::span<const double> points) {
    const std::size_t m = problem.components(), count = points.size();
    IntervalCoefficients at{std::vector<double>(count * m), std::vector<double>(count * m * m),
                            std::vector<double>(count * m)};
    problem.coefficients(points, at);
    return at;
}

IntervalCoefficients coefficients_on(const IntervalProblem& problem, std::span<const double> x) {
    GASPARD_CHECK(x.size() >= 2);
    const std::size_t cells = x.size() - 1, count = cells * gauss_at.size();
    std::vector<double> points(count);
    for (std::size_t i = 0; i < cells; ++i)
        for (std::size_t g = 0; g < gauss_at.size(); ++g)
            points[i * gauss_at.size() + g] = x[i] + (x[i + 1] - x[i]) * gauss_at[g];
    return coefficients_at(problem, points);
}

IntervalSolution solve_interval(const IntervalProblem& problem, std::span<const double> x, int order) {
    return solve_interval(problem, coefficients_on(problem, x), x, order);
}

void check_solution_size(double largest) {
    if (!(largest <= 1e140))
        throw InputError("the solution is not finite, or so large that its energy is not; check the "
                         "coefficients of the problem");
}

IntervalSolution solve_interval(const IntervalProblem& problem, const IntervalCoefficients& at,
                                std::span<const double> x, int order) {
    GASPARD_CHECK(order == 1 || order == 2);
    GASPARD_CHECK(problem.components() == 1 || problem.components() == 2);
    GASPARD_CHECK(at.source.size() == (x.size() - 1) * gauss_at.size() * problem.components());
    IntervalSolution solution =
        problem.components() == 1 ? solve<1>(problem, at, x, order) : solve<2>(problem, at, x, order);
    for (const auto& nodes : solution.nodes)
        for (const double value : nodes) check_solution_size(std::abs(value));
    return solution;
}

double fitting_diffusion(double e, double c, double h) {
    if (c == 0) return 0;
    const double p = std::abs(c) * h / (2 * e);
    return p < 1e-3 ? e * p * p / 3 : e * (p / std::tanh(p) - 1);
}

IntervalSolution solve_fitted(const IntervalProblem& problem, std::span<const double> x) {
    IntervalCoefficients at = coefficients_on(problem, x);
    const std::size_t m = problem.components();
    at.added_diffusion.resize((x.size() - 1) * m);
    for (std::size_t cell = 0; cell + 1 < x.size(); ++cell)
        for (std::size_t k = 0; k < m; ++k) {
            double c = 0;
            for (std::size_t g = 0; g < gauss_at.size(); ++g)
                c += gauss_weight[g] * at.convection[(cell * gauss_at.size() + g) * m + k];
            at.added_diffusion[cell * m + k] =
                fitting_diffusion(problem.diffusion[k], c, x[cell + 1] - x[cell]);
        }
    return solve_interval(problem, at, x, 1);
}

double reference_error(const IntervalProblem& problem, std::span<const double> x, const IntervalSolution& p1,
                       const IntervalSolution& p2) {
    GASPARD_CHECK(p1.order == 1 && p2.order == 2);
    double square = 0;
    for (std::size_t k = 0; k < problem.components(); ++k)
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            const double h = x[i + 1] - x[i];
            const double left = p2.nodes[k][i] - p1.nodes[k][i],
                         right = p2.nodes[k][i + 1] - p1.nodes[k][i + 1];
            // e = linear part + bulge 4 s (1 - s)
            const double bulge = p2.middles[k][i] - 0.5 * (p2.nodes[k][i] + p2.nodes[k][i + 1]);
            const double step = right - left;
            square += problem.diffusion[k] * (step * step + 16.0 / 3 * bulge * bulge) / h;
            square += h * ((left * left + left * right + right * right) / 3 +
                           2.0 / 3 * bulge * (left + right) + 8.0 / 15 * bulge * bulge);
        }
    return std::sqrt(square);
}

namespace {

/// The energy of u - u_h in part [s0, s1] of one cell, by Gauss's rule.
struct CellError {
    const IntervalExact& exact;
    double diffusion, left, h, u0, u1;
    double negligible; ///< energy

    double part(double s0, double s1) const {
        double sum = 0;
        for (std::size_t g = 0; g < gauss_at.size(); ++g) {
            const double s = s0 + (s1 - s0) * gauss_at[g], x = left + h * s;
            const double e = exact.value(x) - (u0 + s * (u1 - u0)), d = exact.slope(x) - (u1 - u0) / h;
            sum += gauss_weight[g] * (diffusion * d * d + e * e);
        }
        return sum * h * (s1 - s0);
    }
    double adaptive(double s0, double s1, double whole, int depth) const {
        const double middle = 0.5 * (s0 + s1), first = part(s0, middle), second = part(middle, s1);
        if (depth == 0 || std::abs(first + second - whole) <= std::max(negligible, 1e-10 * (first + second)))
            return first + second;
        return adaptive(s0, middle, first, depth - 1) + adaptive(middle, s1, second, depth - 1);
    }
};

} // namespace

double exact_error(const IntervalProblem& problem, std::span<const double> x, const IntervalSolution& p1,
                   const IntervalExact& exact) {
    GASPARD_CHECK(problem.components() == 1 && p1.order == 1);
    const auto cell_at = [&](std::size_t i, double negligible) {
        return CellError{exact,          problem.diffusion[0], x[i],      x[i + 1] - x[i],
                         p1.nodes[0][i], p1.nodes[0][i + 1],   negligible};
    };
    double estimate = 0, square = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) estimate += cell_at(i, 0).part(0, 1);
    constexpr int panels = 48, depth = 40;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const CellError cell = cell_at(i, 1e-12 * estimate);
        if (i > 0 && i + 2 < x.size()) {
            square += cell.adaptive(0, 1, cell.part(0, 1), depth);
            continue;
        }
        double end = 0.5; // panels towards both ends, where a layer is that no other point sees
        for (int k = 0; k < panels; ++k, end *= 0.5)
            for (const auto& [s0, s1] : {std::pair(0.5 * end, end), std::pair(1 - end, 1 - 0.5 * end)})
                square += cell.adaptive(s0, s1, cell.part(s0, s1), depth);
    }
    return std::sqrt(square);
}

} // namespace gaspard
