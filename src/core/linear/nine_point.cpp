#include "core/linear/nine_point.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// Entry (a, b) of the matrix of a quadrilateral is number packed[a][b].
constexpr std::array<std::array<std::size_t, 4>, 4> packed = {
    {{0, 1, 3, 6}, {1, 2, 4, 7}, {3, 4, 5, 8}, {6, 7, 8, 9}}};

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    std::array<double, 4> sums{}; // independent of each other, so that additions overlap
    std::size_t i = 0;
    for (; i + 4 <= a.size(); i += 4)
        for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
    for (; i < a.size(); ++i) sums[0] += a[i] * b[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace

NinePointSolver::NinePointSolver(int n) {
    GASPARD_CHECK(n >= 1);
    for (;;) {
        Grid grid;
        grid.n = n;
        const std::size_t size = grid.stride() * grid.stride();
        for (auto* values :
             {&grid.centre, &grid.east, &grid.north, &grid.north_east, &grid.north_west, &grid.row_pivot,
              &grid.column_pivot, &grid.row_next, &grid.column_next, &grid.u, &grid.b, &grid.r})
            values->assign(size, 0.0);
        grid.fixed.assign(size, 1);
        grid.matrices.resize(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
        grids_.push_back(std::move(grid));
        if (n % 2 != 0 || n <= 2) break;
        n /= 2;
        grids_.back().interpolation.resize(static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1));
    }
    for (auto* values : {&direction_, &rest_}) values->assign(grids_.front().u.size(), 0.0);
}

std::span<CornerMatrix> NinePointSolver::matrices() { return grids_.front().matrices; }

void NinePointSolver::factorise(const std::vector<std::uint8_t>& fixed) {
    const auto side = static_cast<std::size_t>(grids_.front().n + 1);
    GASPARD_CHECK(fixed.size() == side * side);
    for (std::size_t level = 0, step = 1; level < grids_.size(); ++level, step *= 2) {
        Grid& g = grids_[level];
        for (std::size_t j = 0; j < side; j += step)
            for (std::size_t i = 0; i < side; i += step)
                g.fixed[g.at(static_cast<int>(i / step), static_cast<int>(j / step))] = fixed[j * side + i];
        assemble(g);
        if (level + 1 < grids_.size()) {
            interpolate(g);
            coarsen(g, grids_[level + 1]);
        }
        factorise_lines(g);
    }
}

/// Couplings, those with fixed points included, which interpolation needs.
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
}

/// Takes away the couplings of fixed points, whose values are 0 from here on, and factorises the tridiagonal
/// systems of all lines: of rows from the left, of columns 0, 2, ... from below, of the others from above.
void NinePointSolver::factorise_lines(Grid& g) {
    const std::size_t s = g.stride();
    for (int j = 0; j <= g.n; ++j)
        for (int i = 0; i <= g.n; ++i) {
            const std::size_t p = g.at(i, j);
            const auto cut = [&](std::vector<double>& coupling, std::size_t q) {
                if (g.fixed[p] != 0 || g.fixed[q] != 0) coupling[p] = 0;
            };
            cut(g.east, p + 1), cut(g.north, p + s), cut(g.north_east, p + s + 1),
                cut(g.north_west, p + s - 1);
            if (g.fixed[p] != 0) g.centre[p] = 0;
        }
    for (int j = 0; j <= g.n; ++j)
        for (int i = 0; i <= g.n; ++i) {
            const std::size_t p = g.at(i, j);
            if (g.fixed[p] != 0) {
                g.row_pivot[p] = g.row_next[p] = g.column_pivot[p] = g.column_next[p] = 0;
                continue;
            }
            g.row_pivot[p] = 1 / (g.centre[p] - g.east[p - 1] * g.row_next[p - 1]);
            g.row_next[p] = g.east[p] * g.row_pivot[p];
            if (i % 2 != 0) continue;
            g.column_pivot[p] = 1 / (g.centre[p] - g.north[p - s] * g.column_next[p - s]);
            g.column_next[p] = g.north[p] * g.column_pivot[p];
        }
    for (int j = g.n; j >= 0; --j)
        for (int i = 1; i <= g.n; i += 2) {
            const std::size_t p = g.at(i, j);
            if (g.fixed[p] != 0) continue;
            g.column_pivot[p] = 1 / (g.centre[p] - g.north[p] * g.column_next[p + s]);
            g.column_next[p] = g.north[p - s] * g.column_pivot[p];
        }
}

/// A point between two coarse ones: the couplings across the line are added to those along it. One between
/// four: from its own equation. Fixed points are not interpolated.
void NinePointSolver::interpolate(Grid& g) {
    const int n = g.n;
    const std::size_t s = g.stride();
    const auto weights = [&](std::size_t p, double a, double b, double across) -> std::array<double, 2> {
        const double denominator = g.centre[p] - across;
        if (g.fixed[p] != 0) return {0, 0};
        // Without a positive denominator or weights (elements of bad shape): the mean.
        if (!(denominator > 0) || a < 0 || b < 0 || a + b > 1.5 * denominator) return {0.5, 0.5};
        return {a / denominator, b / denominator};
    };
    for (int j = 0; j <= n; j += 2)
        for (int i = 0; i <= n; i += 2) {
            auto& cell = g.interpolation[g.coarse(i / 2, j / 2)];
            if (i < n) {
                const std::size_t p = g.at(i + 1, j);
                const double west = g.east[p - 1] + g.north_west[p] + g.north_east[p - s - 1];
                const double east = g.east[p] + g.north_east[p] + g.north_west[p - s + 1];
                cell.south = weights(p, west, east, g.north[p] + g.north[p - s]);
            }
            if (j < n) {
                const std::size_t p = g.at(i, j + 1);
                const double south = g.north[p - s] + g.north_east[p - s - 1] + g.north_west[p - s + 1];
                const double north = g.north[p] + g.north_west[p] + g.north_east[p];
                cell.west = weights(p, south, north, g.east[p] + g.east[p - 1]);
            }
        }
    for (int j = 0; j < n; j += 2)
        for (int i = 0; i < n; i += 2) {
            const std::size_t p = g.at(i + 1, j + 1);
            auto& cell = g.interpolation[g.coarse(i / 2, j / 2)];
            cell.middle = {};
            if (g.fixed[p] != 0) continue;
            const auto &south = cell.south, &west = cell.west,
                       &north = g.interpolation[g.coarse(i / 2, j / 2 + 1)].south,
                       &east = g.interpolation[g.coarse(i / 2 + 1, j / 2)].west;
            const double gs = g.north[p - s], gn = g.north[p], gw = g.east[p - 1], ge = g.east[p];
            const double inverse = 1 / g.centre[p];
            cell.middle = {inverse * (g.north_east[p - s - 1] + gs * south[0] + gw * west[0]),
                           inverse * (g.north_west[p - s + 1] + gs * south[1] + ge * east[0]),
                           inverse * (g.north_west[p] + gn * north[0] + gw * west[1]),
                           inverse * (g.north_east[p] + gn * north[1] + ge * east[1])};
        }
}

/// The Galerkin matrix of every coarse quadrilateral: P^T A P with the nine points of four fine ones.
void NinePointSolver::coarsen(const Grid& fine, Grid& coarse) {
    using Row = std::array<double, 4>;
    const auto n = static_cast<std::size_t>(coarse.n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t at = j * (n + 1) + i; // among the interpolations
            const auto &cell = fine.interpolation[at], &right = fine.interpolation[at + 1],
                       &above = fine.interpolation[at + n + 1];
            const std::array<Row, 9> p = {Row{1, 0, 0, 0}, {cell.south[0], cell.south[1], 0, 0},
                                          {0, 1, 0, 0},    {cell.west[0], 0, cell.west[1], 0},
                                          cell.middle,     {0, right.west[0], 0, right.west[1]},
                                          {0, 0, 1, 0},    {0, 0, above.south[0], above.south[1]},
                                          {0, 0, 0, 1}};
            std::array<Row, 4> sum{};
            for (std::size_t quarter = 0; quarter < 4; ++quarter) {
                const std::size_t a = quarter % 2, b = quarter / 2, first = 3 * b + a;
                const CornerMatrix& m = fine.matrices[(2 * j + b) * 2 * n + 2 * i + a];
                const std::array<std::size_t, 4> corner = {first, first + 1, first + 3, first + 4};
                for (std::size_t k = 0; k < 4; ++k) {
                    Row ap{};
                    for (std::size_t l = 0; l < 4; ++l)
                        for (std::size_t c = 0; c < 4; ++c) ap[c] += m[packed[k][l]] * p[corner[l]][c];
                    for (std::size_t d = 0; d < 4; ++d)
                        for (std::size_t c = 0; c < 4; ++c) sum[d][c] += p[corner[k]][d] * ap[c];
                }
            }
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t d = 0; d <= c; ++d) coarse.matrices[j * n + i][packed[c][d]] = sum[c][d];
        }
}

/// (A v) at point p.
inline double NinePointSolver::Grid::image(const std::vector<double>& v, std::size_t p) const {
    const std::size_t s = stride();
    return centre[p] * v[p] - east[p - 1] * v[p - 1] - east[p] * v[p + 1] - north[p - s] * v[p - s] -
           north_east[p - s - 1] * v[p - s - 1] - north_west[p - s + 1] * v[p - s + 1] - north[p] * v[p + s] -
           north_west[p] * v[p + s - 1] - north_east[p] * v[p + s + 1];
}

/// Solves for the values in a row, the others being given.
void NinePointSolver::relax_row(Grid& g, int j) {
    const std::size_t s = g.stride(), west = g.at(0, j), east = g.at(g.n, j);
    const double *const ne = g.north_east.data(), *const nw = g.north_west.data(), *const no = g.north.data(),
                        *const next = g.row_next.data(), *const pivot = g.row_pivot.data();
    double *const u = g.u.data(), *const r = g.r.data();
    for (std::size_t p = west; p <= east; ++p)
        r[p] = g.b[p] + no[p - s] * u[p - s] + ne[p - s - 1] * u[p - s - 1] + nw[p - s + 1] * u[p - s + 1] +
               no[p] * u[p + s] + nw[p] * u[p + s - 1] + ne[p] * u[p + s + 1];
    double last = 0;
    for (std::size_t p = west; p <= east; ++p) r[p] = last = r[p] + next[p - 1] * last;
    last = 0;
    for (std::size_t p = east + 1; p-- > west;) u[p] = last = r[p] * pivot[p] + next[p] * last;
}

/// Columns first, first + 2, ..., upwards from 0, downwards from 1: the right-hand sides of row j.
void NinePointSolver::eliminate(Grid& g, int first, int j) {
    const std::size_t s = g.stride(), before = first == 0 ? 0 : 2 * s; // p - s or p + s
    const double *const ne = g.north_east.data(), *const nw = g.north_west.data(), *const ea = g.east.data(),
                        *const next = g.column_next.data(), *const u = g.u.data();
    double* const r = g.r.data();
    for (std::size_t p = g.at(first, j), east = g.at(g.n, j); p <= east; p += 2)
        r[p] = g.b[p] + ea[p - 1] * u[p - 1] + ne[p - s - 1] * u[p - s - 1] + nw[p] * u[p + s - 1] +
               ea[p] * u[p + 1] + nw[p - s + 1] * u[p - s + 1] + ne[p] * u[p + s + 1] +
               next[p - s + before] * r[p - s + before];
}

void NinePointSolver::substitute(Grid& g, int first, int j) {
    const std::size_t s = g.stride(), after = first == 0 ? 2 * s : 0;
    for (std::size_t p = g.at(first, j), east = g.at(g.n, j); p <= east; p += 2)
        g.u[p] = g.r[p] * g.column_pivot[p] + g.column_next[p] * g.u[p - s + after];
}

/// Rows 0, 2, ..., then the others, then columns in the same way: three ways through memory, up, down and up
/// again, since each line follows as soon as its neighbours are done. `done(j)` is called when row j has its
/// values.
template <class Done>
void NinePointSolver::relax_before(Grid& g, const Done& done) {
    const int n = g.n;
    for (int j = 0; j <= n + 2; j += 2) {
        if (j <= n) relax_row(g, j);
        if (j > 0 && j - 1 <= n) relax_row(g, j - 1);
        for (const int row : {j - 2, j - 1})
            if (row >= 0 && row <= n) eliminate(g, 0, row);
    }
    for (int j = n; j >= 0; --j) {
        substitute(g, 0, j);
        if (j < n) eliminate(g, 1, j + 1);
    }
    eliminate(g, 1, 0);
    for (int j = 0; j <= n; ++j) {
        substitute(g, 1, j);
        done(j);
    }
}

/// The adjoint: columns 1, 3, ..., then the others, then rows in the same way; down, up and down again.
/// `prepare(j)` is called from above, before rows above j + 1 are used.
template <class Prepare>
void NinePointSolver::relax_after(Grid& g, const Prepare& prepare) {
    const int n = g.n;
    for (int j = n; j >= 0; --j) {
        prepare(j);
        if (j + 2 <= n) eliminate(g, 1, j + 2);
    }
    for (const int row : {1, 0}) eliminate(g, 1, row);
    for (int j = 0; j <= n; ++j) {
        substitute(g, 1, j);
        if (j > 0) eliminate(g, 0, j - 1);
    }
    eliminate(g, 0, n);
    for (int j = n; j >= 0; --j) {
        substitute(g, 0, j);
        if (j % 2 != 0) continue;
        for (const int row : {j + 1, j + 2})
            if (row <= n) relax_row(g, row);
    }
    relax_row(g, 0);
}

/// The residual in a row, after columns 1, 3, ... have been relaxed: it is 0 there.
void NinePointSolver::residual_row(Grid& g, int j) {
    for (std::size_t p = g.at(0, j), east = g.at(g.n, j); p <= east; p += 2)
        g.r[p] = g.b[p] - g.image(g.u, p);
}

/// From the residual in the row of the same place and its neighbours.
void NinePointSolver::restrict_row(const Grid& g, Grid& c, int j) {
    const std::size_t s = g.stride();
    for (int i = 0; i <= c.n; ++i) {
        const std::size_t p = g.at(2 * i, 2 * j), q = c.at(i, j), cell = g.coarse(i, j);
        double sum = g.r[p] + g.interpolation[cell].west[0] * g.r[p + s];
        if (j > 0) sum += g.interpolation[cell - static_cast<std::size_t>(c.n + 1)].west[1] * g.r[p - s];
        c.b[q] = c.fixed[q] != 0 ? 0.0 : sum;
    }
}

/// Adds the coarse correction, which is 0 at fixed points and around the grid, to two rows.
void NinePointSolver::prolong_row(const Grid& c, Grid& g, int j) {
    const std::size_t s = g.stride(), t = c.stride();
    for (int i = 0; i <= c.n; ++i) {
        const std::size_t p = g.at(2 * i, 2 * j), q = c.at(i, j);
        const auto& w = g.interpolation[g.coarse(i, j)];
        const double u00 = c.u[q], u10 = c.u[q + 1], u01 = c.u[q + t], u11 = c.u[q + t + 1];
        g.u[p] += u00;
        g.u[p + 1] += w.south[0] * u00 + w.south[1] * u10;
        g.u[p + s] += w.west[0] * u00 + w.west[1] * u01;
        g.u[p + s + 1] += w.middle[0] * u00 + w.middle[1] * u10 + w.middle[2] * u01 + w.middle[3] * u11;
    }
}

/// One V-cycle for A u = b from u = 0, symmetric: relaxation before and after is adjoint.
void NinePointSolver::cycle(std::size_t level) {
    Grid& g = grids_[level];
    std::fill(g.u.begin(), g.u.end(), 0.0);
    if (level + 1 == grids_.size()) {
        constexpr int sweeps = 4;
        for (int k = 0; k < sweeps; ++k) relax_before(g, [](int) {});
        for (int k = 0; k < sweeps; ++k) relax_after(g, [](int) {});
        return;
    }
    Grid& c = grids_[level + 1]; // of half as many cells: g.n is even
    const auto residual = [&](int j) {
        residual_row(g, j);
        if (j % 2 != 0) restrict_row(g, c, j / 2);
    };
    relax_before(g, [&](int j) {
        if (j > 0) residual(j - 1);
    });
    residual(g.n);
    restrict_row(g, c, c.n);
    cycle(level + 1);
    relax_after(g, [&](int j) {
        if (j % 2 == 0) prolong_row(c, g, j / 2);
    });
}

/// rest = -A u, by quadrilaterals, since couplings with fixed values count here.
void NinePointSolver::start(std::span<const double> u) {
    const Grid& g = grids_.front();
    std::fill(rest_.begin(), rest_.end(), 0.0);
    const auto n = static_cast<std::size_t>(g.n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const CornerMatrix& m = g.matrices[j * n + i];
            const std::size_t q = j * (n + 1) + i, p = g.at(static_cast<int>(i), static_cast<int>(j));
            const std::array<double, 4> v = {u[q], u[q + 1], u[q + n + 1], u[q + n + 2]};
            const std::array<std::size_t, 4> to = {p, p + 1, p + g.stride(), p + g.stride() + 1};
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = 0; b < 4; ++b) rest_[to[a]] -= m[packed[a][b]] * v[b];
        }
    for (std::size_t p = 0; p < rest_.size(); ++p)
        if (g.fixed[p] != 0) rest_[p] = 0;
}

int NinePointSolver::solve(std::span<double> u, double reduction, double smallest) {
    Grid& g = grids_.front();
    const auto n = static_cast<std::size_t>(g.n);
    GASPARD_CHECK(u.size() == (n + 1) * (n + 1));
    start(u);
    double before = 0, first = 0;
    constexpr int most = 200;
    std::fill(direction_.begin(), direction_.end(), 0.0);
    for (int k = 0; k < most; ++k) {
        std::swap(g.b, rest_);
        cycle(0);
        std::swap(g.b, rest_);
        const double square = dot(rest_, g.u);
        double largest = 0;
        for (const double value : g.u) largest = std::max(largest, std::abs(value));
        if (k == 0) first = square;
        if (!(square > 0) || largest <= smallest || (k > 0 && square <= reduction * reduction * first))
            return k;
        const double beta = k == 0 ? 0 : square / before;
        for (int j = 0; j <= g.n + 1; ++j) {
            if (j <= g.n)
                for (std::size_t p = g.at(0, j); p <= g.at(0, j) + n; ++p)
                    direction_[p] = g.u[p] + beta * direction_[p];
            if (j > 0)
                for (std::size_t p = g.at(0, j - 1); p <= g.at(0, j - 1) + n; ++p)
                    g.r[p] = g.image(direction_, p);
        }
        const double step = square / dot(direction_, g.r);
        for (int j = 0; j <= g.n; ++j) {
            const std::size_t p = g.at(0, j), q = static_cast<std::size_t>(j) * (n + 1);
            for (std::size_t i = 0; i <= n; ++i)
                u[q + i] += step * direction_[p + i], rest_[p + i] -= step * g.r[p + i];
        }
        before = square;
    }
    return most;
}

} // namespace gaspard
