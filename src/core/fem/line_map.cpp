#include "core/fem/line_map.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"

#include <algorithm>

namespace gaspard {

namespace {

// Local functions of a cell: left vertex, middle, right vertex (degree 2); left, right (degree 1). On [0,1].
double local_value(int degree, int i, double s) {
    if (degree == 1) return i == 0 ? 1 - s : s;
    return i == 0 ? (1 - s) * (1 - 2 * s) : i == 1 ? 4 * s * (1 - s) : s * (2 * s - 1);
}

double local_slope(int degree, int i, double s) {
    if (degree == 1) return i == 0 ? -1 : 1;
    return i == 0 ? 4 * s - 3 : i == 1 ? 4 - 8 * s : 4 * s - 1;
}

// Integral over one cell of width h, exact.
double local_entry(int test_degree, int test, int trial, LineForm form, double h) {
    static const LineQuadrature rule = gauss_legendre(3);
    double sum = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const double s = rule.points[q];
        const double v =
            form.derive_test ? local_slope(test_degree, test, s) / h : local_value(test_degree, test, s);
        const double u = form.derive_trial ? local_slope(2, trial, s) / h : local_value(2, trial, s);
        sum += rule.weights[q] * h * v * u;
    }
    return sum;
}

} // namespace

LineMap::LineMap(LineGrid grid, int target_degree, Symmetry target_symmetry, LineForm form)
    : grid_(grid), degree_(target_degree), matrix_(grid.size(target_degree)) {
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
                add(global(degree_, cell, i), global(2, cell, j), local_entry(degree_, i, j, form, h));

    // Mass of the vertices. Degree 2: per cell (h/30) [4 2 -1; 2 16 2; -1 2 4], the middle eliminated
    // exactly.
    const double self = degree_ == 1 ? h / 3 : h / 30 * (4 - 4.0 / 16);
    const double neighbour = degree_ == 1 ? h / 6 : h / 30 * (-1 - 4.0 / 16);
    std::vector<double> diagonal(vertices, 2 * self), off(grid.periodic ? vertices : vertices - 1, neighbour);
    if (!grid.periodic) diagonal.front() = diagonal.back() = self;
    if (clamped) {
        diagonal.front() = diagonal.back() = 1;
        off.front() = off.back() = 0;
        matrix_.front().count = matrix_.back().count = 0; // the equations of the ends read: value = 0
    }
    mass_ = TridiagonalSolver(std::move(diagonal), std::move(off), grid.periodic);
}

void LineMap::add(std::size_t row, std::size_t column, double weight) {
    Row& r = matrix_[row];
    for (int k = 0; k < r.count; ++k)
        if (r.index[static_cast<std::size_t>(k)] == column) {
            r.weight[static_cast<std::size_t>(k)] += weight;
            return;
        }
    GASPARD_CHECK(r.count < 5);
    r.index[static_cast<std::size_t>(r.count)] = column;
    r.weight[static_cast<std::size_t>(r.count++)] = weight;
}

void LineMap::apply(const double* in, double* out, std::size_t columns) const {
    for (std::size_t i = 0; i < matrix_.size(); ++i) {
        const Row& row = matrix_[i];
        double* to = out + i * columns;
        std::fill(to, to + columns, 0.0);
        for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k) {
            const double* from = in + row.index[k] * columns;
            const double weight = row.weight[k];
            for (std::size_t c = 0; c < columns; ++c) to[c] += weight * from[c];
        }
    }
    solve_mass(out, columns);
}

void LineMap::solve_mass(double* b, std::size_t columns) const {
    if (degree_ == 1) return mass_.solve(b, columns, columns);
    const std::size_t size = grid_.size(2);
    const double h = grid_.h(), own = 16 * h / 30, coupling = 2 * h / 30;
    const bool clamped = matrix_.front().count == 0;
    const auto vertex_row = [&](std::size_t i) { return b + (i % size) * columns; };
    for (std::size_t middle = 1; middle < size; middle += 2) {
        const double* from = b + middle * columns;
        for (const std::size_t vertex : {middle - 1, middle + 1}) {
            if (clamped && (vertex == 0 || vertex == size - 1)) continue;
            double* to = vertex_row(vertex);
            for (std::size_t c = 0; c < columns; ++c) to[c] -= coupling / own * from[c];
        }
    }
    mass_.solve(b, columns, 2 * columns);
    for (std::size_t middle = 1; middle < size; middle += 2) {
        double* to = b + middle * columns;
        const double* left = vertex_row(middle - 1);
        const double* right = vertex_row(middle + 1);
        for (std::size_t c = 0; c < columns; ++c) to[c] = (to[c] - coupling * (left[c] + right[c])) / own;
    }
}

} // namespace gaspard
