#include "core/linear/nine_point.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

/// Entry (a, b) of the matrix of a quadrilateral.
double entry(const CornerMatrix& m, int a, int b) {
    const int row = std::max(a, b), column = std::min(a, b);
    return m[static_cast<std::size_t>(row * (row + 1) / 2 + column)];
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

} // namespace

NinePointSolver::NinePointSolver(int n, std::vector<std::uint8_t> fixed) {
    GASPARD_CHECK(n >= 1 &&
                  fixed.size() == static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1));
    for (;;) {
        Grid grid;
        grid.n = n;
        const std::size_t size = fixed.size();
        for (auto* values : {&grid.centre, &grid.east, &grid.north, &grid.north_east, &grid.north_west,
                             &grid.row_pivot, &grid.column_pivot, &grid.u, &grid.b, &grid.r})
            values->assign(size, 0.0);
        grid.along.assign(size, {});
        grid.middle.assign(size, {});
        grid.fixed = fixed;
        grids_.push_back(std::move(grid));
        if (n % 2 != 0 || n <= 2) break;
        const Grid& fine = grids_.back();
        n /= 2;
        fixed.clear();
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) fixed.push_back(fine.fixed[fine.at(2 * i, 2 * j)]);
    }
    for (auto* values : {&direction_, &image_, &rest_}) values->assign(grids_.front().u.size(), 0.0);
}

void NinePointSolver::set_matrices(std::vector<CornerMatrix> matrices) {
    GASPARD_CHECK(matrices.size() ==
                  static_cast<std::size_t>(grids_.front().n) * static_cast<std::size_t>(grids_.front().n));
    grids_.front().matrices = std::move(matrices);
    for (std::size_t level = 0; level < grids_.size(); ++level) {
        assemble(grids_[level]);
        if (level + 1 == grids_.size()) break;
        interpolate(grids_[level]);
        coarsen(grids_[level], grids_[level + 1]);
    }
}

/// Couplings and the pivots of all lines. A fixed unknown keeps a row of its own: a unit pivot.
void NinePointSolver::assemble(Grid& g) {
    for (auto* values : {&g.centre, &g.east, &g.north, &g.north_east, &g.north_west})
        std::fill(values->begin(), values->end(), 0.0);
    const int n = g.n;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const CornerMatrix& m = g.matrices[static_cast<std::size_t>(j * n + i)];
            const std::size_t p = g.at(i, j), q = g.at(i, j + 1);
            g.centre[p] += m[0], g.centre[p + 1] += m[2], g.centre[q] += m[5], g.centre[q + 1] += m[9];
            g.east[p] -= m[1], g.east[q] -= m[8];
            g.north[p] -= m[3], g.north[p + 1] -= m[7];
            g.north_west[p + 1] -= m[4], g.north_east[p] -= m[6];
        }
    const auto stride = static_cast<std::size_t>(n + 1);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const std::size_t p = g.at(i, j);
            if (g.fixed[p] != 0) {
                g.row_pivot[p] = g.column_pivot[p] = 0; // neither takes nor gives
                continue;
            }
            double row = g.centre[p], column = g.centre[p];
            if (i > 0) row -= g.east[p - 1] * g.east[p - 1] * g.row_pivot[p - 1];
            if (j > 0) column -= g.north[p - stride] * g.north[p - stride] * g.column_pivot[p - stride];
            g.row_pivot[p] = 1 / row, g.column_pivot[p] = 1 / column;
        }
}

/// A point between two coarse ones: the couplings across the line are added to those along it. One between
/// four: from its own equation.
void NinePointSolver::interpolate(Grid& g) {
    const int n = g.n;
    const auto s = static_cast<std::size_t>(n + 1);
    const auto value = [](const std::vector<double>& v, std::size_t p, bool there) {
        return there ? v[p] : 0.0;
    };
    const auto weights = [](double a, double b, double denominator) -> std::array<double, 2> {
        // Without a positive denominator or weights (elements of bad shape): the mean.
        if (!(denominator > 0) || a < 0 || b < 0 || a + b > 1.5 * denominator) return {0.5, 0.5};
        return {a / denominator, b / denominator};
    };
    for (int j = 0; j <= n; j += 2)
        for (int i = 1; i < n; i += 2) {
            const std::size_t p = g.at(i, j);
            const bool up = j<n, down = j> 0;
            const double north = value(g.north, p, up), south = down ? g.north[p - s] : 0.0;
            const double west =
                g.east[p - 1] + value(g.north_west, p, up) + (down ? g.north_east[p - s - 1] : 0.0);
            const double east =
                g.east[p] + value(g.north_east, p, up) + (down ? g.north_west[p - s + 1] : 0.0);
            g.along[p] = weights(west, east, g.centre[p] - north - south);
        }
    for (int j = 1; j < n; j += 2)
        for (int i = 0; i <= n; i += 2) {
            const std::size_t p = g.at(i, j);
            const bool right = i<n, left = i> 0;
            const double east = value(g.east, p, right), west = left ? g.east[p - 1] : 0.0;
            const double south = g.north[p - s] + (left ? g.north_east[p - s - 1] : 0.0) +
                                 (right ? g.north_west[p - s + 1] : 0.0);
            const double north = g.north[p] + value(g.north_west, p, left) + value(g.north_east, p, right);
            g.along[p] = weights(south, north, g.centre[p] - east - west);
        }
    for (int j = 1; j < n; j += 2)
        for (int i = 1; i < n; i += 2) {
            const std::size_t p = g.at(i, j), south = p - s, north = p + s, west = p - 1, east = p + 1;
            const auto free = [&](std::size_t q) { return g.fixed[q] == 0 ? 1.0 : 0.0; };
            const double gs = g.north[south] * free(south), gn = g.north[p] * free(north);
            const double gw = g.east[west] * free(west), ge = g.east[p] * free(east);
            const double inverse = 1 / g.centre[p];
            g.middle[p] = {
                inverse * (g.north_east[south - 1] + gs * g.along[south][0] + gw * g.along[west][0]),
                inverse * (g.north_west[south + 1] + gs * g.along[south][1] + ge * g.along[east][0]),
                inverse * (g.north_west[p] + gn * g.along[north][0] + gw * g.along[west][1]),
                inverse * (g.north_east[p] + gn * g.along[north][1] + ge * g.along[east][1])};
        }
}

/// The Galerkin matrix of every coarse quadrilateral: P^T A P with the nine points of four fine ones.
void NinePointSolver::coarsen(const Grid& fine, Grid& coarse) {
    const int n = coarse.n;
    coarse.matrices.resize(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            std::array<std::array<double, 4>, 9> p{};
            p[0] = {1, 0, 0, 0}, p[2] = {0, 1, 0, 0}, p[6] = {0, 0, 1, 0}, p[8] = {0, 0, 0, 1};
            const auto along = [&](int a, int b) { return fine.along[fine.at(2 * i + a, 2 * j + b)]; };
            const auto south = along(1, 0), north = along(1, 2), west = along(0, 1), east = along(2, 1);
            p[1] = {south[0], south[1], 0, 0}, p[7] = {0, 0, north[0], north[1]};
            p[3] = {west[0], 0, west[1], 0}, p[5] = {0, east[0], 0, east[1]};
            p[4] = fine.middle[fine.at(2 * i + 1, 2 * j + 1)];
            for (int b = 0; b < 3; ++b)
                for (int a = 0; a < 3; ++a) // fixed points are not interpolated
                    if ((a == 1 || b == 1) && fine.fixed[fine.at(2 * i + a, 2 * j + b)] != 0)
                        p[static_cast<std::size_t>(3 * b + a)] = {};
            CornerMatrix sum{};
            for (int quarter = 0; quarter < 4; ++quarter) {
                const int a = quarter % 2, b = quarter / 2;
                const CornerMatrix& m =
                    fine.matrices[static_cast<std::size_t>((2 * j + b) * fine.n + 2 * i + a)];
                const std::array<int, 4> corner = {3 * b + a, 3 * b + a + 1, 3 * b + a + 3, 3 * b + a + 4};
                std::array<std::array<double, 4>, 4> ap{};
                for (int k = 0; k < 4; ++k)
                    for (int l = 0; l < 4; ++l)
                        for (std::size_t c = 0; c < 4; ++c)
                            ap[static_cast<std::size_t>(k)][c] +=
                                entry(m, k, l) *
                                p[static_cast<std::size_t>(corner[static_cast<std::size_t>(l)])][c];
                std::size_t at = 0;
                for (std::size_t c = 0; c < 4; ++c)
                    for (std::size_t d = 0; d <= c; ++d, ++at)
                        for (std::size_t k = 0; k < 4; ++k)
                            sum[at] += p[static_cast<std::size_t>(corner[k])][c] * ap[k][d];
            }
            coarse.matrices[static_cast<std::size_t>(j * n + i)] = sum;
        }
}

/// r = b - A u at free points, 0 at others.
void NinePointSolver::residual(Grid& g) {
    const int n = g.n;
    const auto s = static_cast<std::size_t>(n + 1);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const std::size_t p = g.at(i, j);
            if (g.fixed[p] != 0) {
                g.r[p] = 0;
                continue;
            }
            double sum = g.b[p] - g.centre[p] * g.u[p];
            if (i > 0) sum += g.east[p - 1] * g.u[p - 1];
            if (i < n) sum += g.east[p] * g.u[p + 1];
            if (j > 0) {
                sum += g.north[p - s] * g.u[p - s];
                if (i > 0) sum += g.north_east[p - s - 1] * g.u[p - s - 1];
                if (i < n) sum += g.north_west[p - s + 1] * g.u[p - s + 1];
            }
            if (j < n) {
                sum += g.north[p] * g.u[p + s];
                if (i > 0) sum += g.north_west[p] * g.u[p + s - 1];
                if (i < n) sum += g.north_east[p] * g.u[p + s + 1];
            }
            g.r[p] = sum;
        }
}

/// Solves every second row for the values in it, the others being given.
void NinePointSolver::relax_rows(Grid& g, int first) {
    const int n = g.n;
    const auto s = static_cast<std::size_t>(n + 1);
    for (int j = first; j <= n; j += 2) {
        for (int i = 0; i <= n; ++i) {
            const std::size_t p = g.at(i, j);
            double sum = g.b[p];
            if (j > 0) {
                sum += g.north[p - s] * g.u[p - s];
                if (i > 0) sum += g.north_east[p - s - 1] * g.u[p - s - 1];
                if (i < n) sum += g.north_west[p - s + 1] * g.u[p - s + 1];
            }
            if (j < n) {
                sum += g.north[p] * g.u[p + s];
                if (i > 0) sum += g.north_west[p] * g.u[p + s - 1];
                if (i < n) sum += g.north_east[p] * g.u[p + s + 1];
            }
            // A fixed value is known: its coupling goes to the right-hand side.
            if (i > 0)
                sum += g.east[p - 1] * (g.fixed[p - 1] != 0 ? g.u[p - 1] : g.r[p - 1] * g.row_pivot[p - 1]);
            if (i < n && g.fixed[p + 1] != 0) sum += g.east[p] * g.u[p + 1];
            g.r[p] = sum;
        }
        double next = 0;
        for (int i = n; i >= 0; --i) {
            const std::size_t p = g.at(i, j);
            if (g.fixed[p] == 0) g.u[p] = (g.r[p] + next) * g.row_pivot[p];
            next = i > 0 && g.fixed[p] == 0 ? g.east[p - 1] * g.u[p] : 0;
        }
    }
}

void NinePointSolver::relax_columns(Grid& g, int first) {
    const int n = g.n;
    const auto s = static_cast<std::size_t>(n + 1);
    for (int j = 0; j <= n; ++j)
        for (int i = first; i <= n; i += 2) {
            const std::size_t p = g.at(i, j);
            double sum = g.b[p];
            if (i > 0) {
                sum += g.east[p - 1] * g.u[p - 1];
                if (j > 0) sum += g.north_east[p - s - 1] * g.u[p - s - 1];
                if (j < n) sum += g.north_west[p] * g.u[p + s - 1];
            }
            if (i < n) {
                sum += g.east[p] * g.u[p + 1];
                if (j > 0) sum += g.north_west[p - s + 1] * g.u[p - s + 1];
                if (j < n) sum += g.north_east[p] * g.u[p + s + 1];
            }
            if (j > 0)
                sum +=
                    g.north[p - s] * (g.fixed[p - s] != 0 ? g.u[p - s] : g.r[p - s] * g.column_pivot[p - s]);
            if (j < n && g.fixed[p + s] != 0) sum += g.north[p] * g.u[p + s];
            g.r[p] = sum;
        }
    for (int j = n; j >= 0; --j)
        for (int i = first; i <= n; i += 2) {
            const std::size_t p = g.at(i, j);
            if (g.fixed[p] != 0) continue;
            const double next = j < n && g.fixed[p + s] == 0 ? g.north[p] * g.u[p + s] : 0;
            g.u[p] = (g.r[p] + next) * g.column_pivot[p];
        }
}

/// One V-cycle for A u = b from u = 0 (fixed values are 0), symmetric: relaxation before and after is
/// adjoint.
void NinePointSolver::cycle(std::size_t level) {
    Grid& g = grids_[level];
    std::fill(g.u.begin(), g.u.end(), 0.0);
    const bool coarsest = level + 1 == grids_.size();
    const int sweeps = coarsest ? 4 : 1;
    for (int k = 0; k < sweeps; ++k)
        relax_rows(g, 0), relax_rows(g, 1), relax_columns(g, 0), relax_columns(g, 1);
    if (!coarsest) {
        residual(g);
        Grid& c = grids_[level + 1];
        const int n = c.n;
        const auto s = static_cast<std::size_t>(g.n + 1);
        std::fill(c.b.begin(), c.b.end(), 0.0);
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const std::size_t p = g.at(2 * i, 2 * j);
                double sum = g.r[p];
                if (i > 0) sum += g.along[p - 1][1] * g.r[p - 1];
                if (i < n) sum += g.along[p + 1][0] * g.r[p + 1];
                if (j > 0) {
                    sum += g.along[p - s][1] * g.r[p - s];
                    if (i > 0) sum += g.middle[p - s - 1][3] * g.r[p - s - 1];
                    if (i < n) sum += g.middle[p - s + 1][2] * g.r[p - s + 1];
                }
                if (j < n) {
                    sum += g.along[p + s][0] * g.r[p + s];
                    if (i > 0) sum += g.middle[p + s - 1][1] * g.r[p + s - 1];
                    if (i < n) sum += g.middle[p + s + 1][0] * g.r[p + s + 1];
                }
                c.b[c.at(i, j)] = c.fixed[c.at(i, j)] != 0 ? 0.0 : sum;
            }
        cycle(level + 1);
        for (int j = 0; j <= g.n; ++j)
            for (int i = 0; i <= g.n; ++i) {
                const std::size_t p = g.at(i, j);
                if (g.fixed[p] != 0) continue;
                const std::size_t q = c.at(i / 2, j / 2), t = static_cast<std::size_t>(n + 1);
                if (i % 2 == 0 && j % 2 == 0)
                    g.u[p] += c.u[q];
                else if (j % 2 == 0)
                    g.u[p] += g.along[p][0] * c.u[q] + g.along[p][1] * c.u[q + 1];
                else if (i % 2 == 0)
                    g.u[p] += g.along[p][0] * c.u[q] + g.along[p][1] * c.u[q + t];
                else
                    g.u[p] += g.middle[p][0] * c.u[q] + g.middle[p][1] * c.u[q + 1] +
                              g.middle[p][2] * c.u[q + t] + g.middle[p][3] * c.u[q + t + 1];
            }
    }
    for (int k = 0; k < sweeps; ++k)
        relax_columns(g, 1), relax_columns(g, 0), relax_rows(g, 1), relax_rows(g, 0);
}

int NinePointSolver::solve(std::span<double> u, double reduction, double smallest) {
    Grid& g = grids_.front();
    GASPARD_CHECK(u.size() == g.u.size());
    const auto apply = [&](const auto& of, double sign) { // g.r = sign * A of
        std::copy(of.begin(), of.end(), g.u.begin());
        std::fill(g.b.begin(), g.b.end(), 0.0);
        residual(g);
        for (double& value : g.r) value *= -sign;
    };
    apply(u, -1);
    rest_ = g.r;
    double before = 0, first = 0;
    constexpr int most = 200;
    for (int k = 0; k < most; ++k) {
        g.b = rest_;
        cycle(0);
        const double square = dot(rest_, g.u);
        double largest = 0;
        for (const double value : g.u) largest = std::max(largest, std::abs(value));
        if (k == 0) first = square;
        if (!(square > 0) || largest <= smallest || (k > 0 && square <= reduction * reduction * first))
            return k;
        const double beta = k == 0 ? 0 : square / before;
        for (std::size_t i = 0; i < direction_.size(); ++i) direction_[i] = g.u[i] + beta * direction_[i];
        apply(direction_, 1);
        const double step = square / dot(direction_, g.r);
        for (std::size_t i = 0; i < direction_.size(); ++i)
            u[i] += step * direction_[i], rest_[i] -= step * g.r[i];
        before = square;
    }
    return most;
}

} // namespace gaspard
