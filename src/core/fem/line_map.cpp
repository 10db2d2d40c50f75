#include "core/fem/line_map.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"

#include <algorithm>

namespace gaspard {

namespace {

// Basis functions on [0, 1]: left vertex, midpoint, right vertex (degree 2); left, right (degree 1).
double local_value(int degree, int i, double s) {
    if (degree == 1) return i == 0 ? 1 - s : s;
    return i == 0 ? (1 - s) * (1 - 2 * s) : i == 1 ? 4 * s * (1 - s) : s * (2 * s - 1);
}

double local_slope(int degree, int i, double s) {
    if (degree == 1) return i == 0 ? -1 : 1;
    return i == 0 ? 4 * s - 3 : i == 1 ? 4 - 8 * s : 4 * s - 1;
}

// Integral over one cell of width h; exact.
double local_entry(int test_degree, int test, int trial, LineForm form, double h) {
    static const LineQuadrature rule = gauss_legendre(3);
    double sum = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const double s = rule.points[q];
        const double v =
            form.derive_test ? local_slope(test_degree, test, s) / h : local_value(test_degree, test, s);
        const double u = form.derive_trial ? local_slope(2, trial, s) / h : local_value(2, trial, s);
        sum += form.factor * rule.weights[q] * h * v * u;
    }
    return sum;
}

} // namespace

LineMap::LineMap(LineGrid grid, int target_degree, Symmetry target_symmetry, LineForm form)
    : grid_(grid), degree_(target_degree), rows_(grid.size(target_degree)) {
    GASPARD_CHECK(grid.cells >= 4 && (degree_ == 1 || degree_ == 2));
    const std::size_t n = grid.cells, vertices = grid.vertices();
    const double h = grid.h();
    const bool clamped = !grid.periodic && target_symmetry == Symmetry::odd;

    const int locals = degree_ + 1;
    const auto global = [&](int degree, std::size_t cell, int local) {
        if (degree == 1) return (cell + static_cast<std::size_t>(local)) % vertices;
        return (2 * cell + static_cast<std::size_t>(local)) % grid.size(2);
    };
    for (std::size_t cell = 0; cell < n; ++cell)
        for (int i = 0; i < locals; ++i)
            for (int j = 0; j < 3; ++j)
                rows_[global(degree_, cell, i)].add(global(2, cell, j), local_entry(degree_, i, j, form, h));

    // Mass matrix of the vertices. For degree 2, cell matrix (h/30) [4 2 -1; 2 16 2; -1 2 4] with the
    // midpoint eliminated (Schur complement).
    const double self = degree_ == 1 ? h / 3 : h / 30 * (4 - 4.0 / 16);
    const double neighbour = degree_ == 1 ? h / 6 : h / 30 * (-1 - 4.0 / 16);
    std::vector<double> diagonal(vertices, 2 * self), off(grid.periodic ? vertices : vertices - 1, neighbour);
    if (!grid.periodic) diagonal.front() = diagonal.back() = self;
    if (clamped) {
        diagonal.front() = diagonal.back() = 1;
        off.front() = off.back() = 0;
        rows_.front() = rows_.back() = {}; // end equations: value = 0
    }
    if (degree_ == 2) eliminate_middles(h, clamped);
    mass_ = TridiagonalSolver(std::move(diagonal), std::move(off), grid.periodic);
}

void LineMap::Row::add(std::size_t column, double by) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
        if (index[k] == column) {
            weight[k] += by;
            return;
        }
    GASPARD_CHECK(count < 5);
    index[static_cast<std::size_t>(count)] = column;
    weight[static_cast<std::size_t>(count++)] = by;
}

// Static condensation. Midpoint equation: own m + coupling (left + right) = b. The midpoints are eliminated
// from the vertex equations; midpoint rows are divided by `own`.
void LineMap::eliminate_middles(double h, bool clamped) {
    const double own = 16 * h / 30, coupling = 2 * h / 30;
    neighbours_ = coupling / own;
    for (std::size_t middle = 1; middle < rows_.size(); middle += 2) {
        Row& row = rows_[middle];
        for (double& weight : row.weight) weight /= own;
        for (const std::size_t vertex : {middle - 1, (middle + 1) % rows_.size()}) {
            if (clamped && (vertex == 0 || vertex + 1 == rows_.size())) continue;
            for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
                rows_[vertex].add(row.index[k], -coupling * row.weight[k]);
        }
    }
}

void LineMap::apply(const double* in, std::size_t in_stride, double* out, std::size_t out_stride,
                    std::size_t columns) const {
    const auto input = [&](const Row& row, std::size_t k) { return in + row.index[k] * in_stride; };
    const std::size_t step = degree_ == 2 ? 2 : 1;
    for (std::size_t i = 0; i < rows_.size(); i += step) {
        const Row& row = rows_[i];
        const auto& w = row.weight;
        const double *a = input(row, 0), *b = input(row, 1), *c = input(row, 2), *d = input(row, 3),
                     *e = input(row, 4);
        double* __restrict to = out + i * out_stride;
        for (std::size_t l = 0; l < columns; ++l)
            to[l] = w[0] * a[l] + w[1] * b[l] + w[2] * c[l] + w[3] * d[l] + w[4] * e[l];
    }
    mass_.solve(out, columns, step * out_stride);
    if (degree_ == 1) return;
    for (std::size_t i = 1; i < rows_.size(); i += 2) {
        const Row& row = rows_[i];
        const auto& w = row.weight;
        const double *a = input(row, 0), *b = input(row, 1), *c = input(row, 2);
        const double* left = out + (i - 1) * out_stride;
        const double* right = out + (i + 1) % rows_.size() * out_stride;
        double* __restrict to = out + i * out_stride;
        for (std::size_t l = 0; l < columns; ++l)
            to[l] = w[0] * a[l] + w[1] * b[l] + w[2] * c[l] - neighbours_ * (left[l] + right[l]);
    }
}

} // namespace gaspard
