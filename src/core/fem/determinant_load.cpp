#include "core/fem/determinant_load.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

struct DeterminantLoad::Fields {
    std::array<const double*, 2> density{}; ///< m, dm
    std::array<const double*, 6> sigma{};   ///< components xx, yy, xy of sigma, then of dsigma
};

DeterminantLoad::DeterminantLoad(LineGrid grid) : grid_(grid) {
    const LineQuadrature rule = gauss_legendre(static_cast<int>(gauss));
    for (std::size_t q = 0; q < gauss; ++q) {
        const double s = rule.points[q], weight = rule.weights[q] * grid.h();
        const double left = (1 - s) * (1 - 2 * s), middle = 4 * s * (1 - s), right = s * (2 * s - 1);
        points_[q] = {left, middle, right, 1 - s, s, weight * left, weight * middle, weight * right};
    }
}

// Layouts: values [row of nodes][component][p][cell], density [row][p][cell], tested [b][p][cell]; p is the
// Gauss point along x and b the basis function along y.
DeterminantLoad::Workspace DeterminantLoad::make_workspace() const {
    const std::size_t n = grid_.cells, size = grid_.size(2);
    return {std::vector<double>(2 * 3 * 3 * gauss * n), std::vector<double>(2 * 2 * gauss * n),
            std::vector<double>(3 * gauss * n), std::vector<double>(size + 1), std::vector<double>(size)};
}

void DeterminantLoad::integrate(std::span<const double> monitor, const WeakHessian& sigma,
                                std::span<double> r, std::span<Workspace> workspaces, Team& team) const {
    const std::size_t size = grid_.size(2), side = grid_.cells + 1;
    GASPARD_CHECK(monitor.size() == side * side && r.size() == size * size);
    for (const auto* part : {&sigma.xx, &sigma.yy, &sigma.xy}) GASPARD_CHECK(part->size() == size * size);
    integrate_all<1>({{monitor.data()}, {sigma.xx.data(), sigma.yy.data(), sigma.xy.data()}}, r, workspaces,
                     team);
}

void DeterminantLoad::differentiate(std::span<const double> monitor, const WeakHessian& sigma,
                                    std::span<const double> d_monitor, const WeakHessian& d_sigma,
                                    std::span<double> r, std::span<Workspace> workspaces, Team& team) const {
    const std::size_t size = grid_.size(2), side = grid_.cells + 1;
    GASPARD_CHECK(monitor.size() == side * side && d_monitor.size() == side * side);
    GASPARD_CHECK(r.size() == size * size);
    for (const auto* hessian : {&sigma, &d_sigma})
        for (const auto* part : {&hessian->xx, &hessian->yy, &hessian->xy})
            GASPARD_CHECK(part->size() == size * size);
    integrate_all<2>({{monitor.data(), d_monitor.data()},
                      {sigma.xx.data(), sigma.yy.data(), sigma.xy.data(), d_sigma.xx.data(),
                       d_sigma.yy.data(), d_sigma.xy.data()}},
                     r, workspaces, team);
}

template <std::size_t fields>
void DeterminantLoad::integrate_all(const Fields& from, std::span<double> r, std::span<Workspace> workspaces,
                                    Team& team) const {
    GASPARD_CHECK(workspaces.size() >= team.workers());
    const std::size_t workers = team.workers(), n = grid_.cells, size = grid_.size(2);
    team.share(n, [&](std::size_t worker, std::size_t begin, std::size_t end) {
        if (begin < end) integrate_rows<fields>(begin, end, from, r, workspaces[worker]);
    });
    // Add the two contributions to each row of nodes at the boundary between two workers.
    for (std::size_t worker = 0; worker < workers; ++worker) {
        const std::size_t begin = n * worker / workers, end = n * (worker + 1) / workers;
        if (begin == end) continue;
        double* row = r.data() + 2 * end % size * size;
        const bool wall = 2 * end % size == 2 * n;
        for (std::size_t i = 0; i < size; ++i) row[i] = (wall ? 0.0 : row[i]) + workspaces[worker].top[i];
    }
}

template <std::size_t fields>
void DeterminantLoad::integrate_rows(std::size_t begin, std::size_t end, const Fields& from,
                                     std::span<double> r, Workspace& workspace) const {
    const std::size_t n = grid_.cells, size = grid_.size(2), slot = gauss * n;
    std::array<double*, 3> rows; // nodal rows of the cells: bottom, middle, top
    for (std::size_t b = 0; b < 3; ++b) rows[b] = workspace.values.data() + b * 3 * fields * slot;
    std::array<double*, 2> density{workspace.density.data(), workspace.density.data() + fields * slot};
    const auto load = [&](std::size_t row, double* values) {
        for (std::size_t part = 0; part < 3 * fields; ++part)
            along_x(from.sigma[part] + row % size * size, values + part * slot);
    };
    const auto load_density = [&](std::size_t row, double* values) {
        for (std::size_t part = 0; part < fields; ++part)
            density_along_x(from.density[part] + row * (n + 1), values + part * slot);
    };
    load(2 * begin, rows[0]);
    load_density(begin, density[0]);
    for (std::size_t j = begin; j < end; ++j) {
        load(2 * j + 1, rows[1]);
        load(2 * j + 2, rows[2]);
        load_density(j + 1, density[1]);
        for (std::size_t p = 0; p < gauss; ++p)
            test_along_y<fields>(p, rows, density, workspace.tested.data());
        for (std::size_t b = 0; b < 3; ++b) {
            test_along_x(workspace.tested.data() + b * slot, workspace.row.data());
            double* to = b == 2 && j + 1 == end ? workspace.top.data() : r.data() + (2 * j + b) * size;
            const bool begun = b == 0 && j > begin; // has contributions from the cells below
            for (std::size_t i = 0; i < size; ++i) to[i] = (begun ? to[i] : 0.0) + workspace.row[i];
        }
        std::swap(rows[0], rows[2]);
        std::swap(density[0], density[1]);
    }
}

void DeterminantLoad::along_x(const double* nodes, double* values) const {
    const std::size_t n = grid_.cells;
    interpolate_cells(nodes, values, values + n, values + 2 * n, values + 3 * n);
    for (std::size_t p = 0; p < gauss; ++p) // the last cell, which wraps around if periodic
        values[p * n + n - 1] = points_[p].left * nodes[2 * n - 2] + points_[p].middle * nodes[2 * n - 1] +
                                points_[p].right * nodes[2 * n % grid_.size(2)];
}

// All cells except the last, at the four points; each node is read once.
void DeterminantLoad::interpolate_cells(const double* nodes, double* __restrict v0, double* __restrict v1,
                                        double* __restrict v2, double* __restrict v3) const {
    const double l0 = points_[0].left, m0 = points_[0].middle, r0 = points_[0].right;
    const double l1 = points_[1].left, m1 = points_[1].middle, r1 = points_[1].right;
    const double l2 = points_[2].left, m2 = points_[2].middle, r2 = points_[2].right;
    const double l3 = points_[3].left, m3 = points_[3].middle, r3 = points_[3].right;
    for (std::size_t c = 0; c + 1 < grid_.cells; ++c) {
        const double left = nodes[2 * c], middle = nodes[2 * c + 1], right = nodes[2 * c + 2];
        v0[c] = l0 * left + m0 * middle + r0 * right;
        v1[c] = l1 * left + m1 * middle + r1 * right;
        v2[c] = l2 * left + m2 * middle + r2 * right;
        v3[c] = l3 * left + m3 * middle + r3 * right;
    }
}

void DeterminantLoad::density_along_x(const double* monitor, double* density) const {
    const std::size_t n = grid_.cells;
    for (std::size_t p = 0; p < gauss; ++p) {
        const Point at = points_[p];
        double* __restrict to = density + p * n;
        for (std::size_t c = 0; c < n; ++c) to[c] = at.q1_left * monitor[c] + at.q1_right * monitor[c + 1];
    }
}

// At one Gauss point along y: interpolates from three rows of nodes (two for the density), evaluates
// m det(I + sigma) and adds its contribution to the three integrals.
void DeterminantLoad::add_point(const Point& at, const Rows<1>& rows, double* __restrict t0,
                                double* __restrict t1, double* __restrict t2) const {
    const auto [left, middle, right, q1_left, q1_right, test_left, test_middle, test_right] = at;
    const auto [x0, x1, x2] = rows.sigma[0];
    const auto [y0, y1, y2] = rows.sigma[1];
    const auto [z0, z1, z2] = rows.sigma[2];
    const auto [m0, m1] = rows.density[0];
    for (std::size_t c = 0; c < grid_.cells; ++c) {
        const double xx = 1 + left * x0[c] + middle * x1[c] + right * x2[c];
        const double yy = 1 + left * y0[c] + middle * y1[c] + right * y2[c];
        const double xy = left * z0[c] + middle * z1[c] + right * z2[c];
        const double f = (q1_left * m0[c] + q1_right * m1[c]) * (xx * yy - xy * xy);
        t0[c] += test_left * f;
        t1[c] += test_middle * f;
        t2[c] += test_right * f;
    }
}

// The same for dm det(I + sigma) + m cof(I + sigma) : dsigma.
void DeterminantLoad::add_point(const Point& at, const Rows<2>& rows, double* __restrict t0,
                                double* __restrict t1, double* __restrict t2) const {
    const auto [left, middle, right, q1_left, q1_right, test_left, test_middle, test_right] = at;
    const auto [x0, x1, x2] = rows.sigma[0];
    const auto [y0, y1, y2] = rows.sigma[1];
    const auto [z0, z1, z2] = rows.sigma[2];
    const auto [dx0, dx1, dx2] = rows.sigma[3];
    const auto [dy0, dy1, dy2] = rows.sigma[4];
    const auto [dz0, dz1, dz2] = rows.sigma[5];
    const auto [m0, m1] = rows.density[0];
    const auto [dm0, dm1] = rows.density[1];
    for (std::size_t c = 0; c < grid_.cells; ++c) {
        const double xx = 1 + left * x0[c] + middle * x1[c] + right * x2[c];
        const double yy = 1 + left * y0[c] + middle * y1[c] + right * y2[c];
        const double xy = left * z0[c] + middle * z1[c] + right * z2[c];
        const double dxx = left * dx0[c] + middle * dx1[c] + right * dx2[c];
        const double dyy = left * dy0[c] + middle * dy1[c] + right * dy2[c];
        const double dxy = left * dz0[c] + middle * dz1[c] + right * dz2[c];
        const double m = q1_left * m0[c] + q1_right * m1[c], dm = q1_left * dm0[c] + q1_right * dm1[c];
        const double f = dm * (xx * yy - xy * xy) + m * (yy * dxx + xx * dyy - 2 * xy * dxy);
        t0[c] += test_left * f;
        t1[c] += test_middle * f;
        t2[c] += test_right * f;
    }
}

// For the p-th Gauss points along x.
template <std::size_t fields>
void DeterminantLoad::test_along_y(std::size_t p, const std::array<double*, 3>& rows,
                                   const std::array<double*, 2>& density, double* tested) const {
    const std::size_t n = grid_.cells, slot = gauss * n;
    Rows<fields> lines;
    for (std::size_t part = 0; part < 3 * fields; ++part)
        for (std::size_t b = 0; b < 3; ++b) lines.sigma[part][b] = rows[b] + part * slot + p * n;
    for (std::size_t part = 0; part < fields; ++part)
        for (std::size_t b = 0; b < 2; ++b) lines.density[part][b] = density[b] + part * slot + p * n;
    double *t0 = tested + p * n, *t1 = t0 + slot, *t2 = t1 + slot;
    for (double* sum : {t0, t1, t2}) std::fill(sum, sum + n, 0.0);
    for (const Point& at : points_) add_point(at, lines, t0, t1, t2);
}

void DeterminantLoad::test_along_x(const double* tested, double* row) const {
    const std::size_t n = grid_.cells;
    const double *f0 = tested, *f1 = f0 + n, *f2 = f1 + n, *f3 = f2 + n;
    const Point p0 = points_[0], p1 = points_[1], p2 = points_[2], p3 = points_[3];
    const auto left = [&](std::size_t c) {
        return p0.test_left * f0[c] + p1.test_left * f1[c] + p2.test_left * f2[c] + p3.test_left * f3[c];
    };
    const auto middle = [&](std::size_t c) {
        return p0.test_middle * f0[c] + p1.test_middle * f1[c] + p2.test_middle * f2[c] +
               p3.test_middle * f3[c];
    };
    const auto right = [&](std::size_t c) {
        return p0.test_right * f0[c] + p1.test_right * f1[c] + p2.test_right * f2[c] + p3.test_right * f3[c];
    };
    double* __restrict to = row;
    for (std::size_t c = 1; c < n; ++c) to[2 * c] = left(c) + right(c - 1);
    for (std::size_t c = 0; c < n; ++c) to[2 * c + 1] = middle(c);
    const double first = left(0), last = right(n - 1);
    to[0] = grid_.periodic ? first + last : first;
    to[2 * n] = last; // walls only; workspace rows always have this entry
}

} // namespace gaspard
