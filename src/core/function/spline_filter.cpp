#include "core/function/spline_filter.hpp"

#include "core/base/check.hpp"
#include "core/linear/tridiagonal.hpp"

#include <algorithm>
#include <vector>

namespace gaspard {

namespace {

/// row(to) = sum of weights times rows; `to` may be among them.
struct Term {
    std::ptrdiff_t row;
    double weight;
};
void combine(const GridRows& rows, std::ptrdiff_t to, std::initializer_list<Term> terms) {
    double* target = rows.row(to);
    for (std::size_t c = 0; c < rows.columns; ++c) {
        double sum = 0;
        for (const Term& term : terms) sum += term.weight * rows.row(term.row)[c];
        target[c] = sum;
    }
}

void scale(const GridRows& rows, std::ptrdiff_t row, double factor) {
    for (std::size_t c = 0; c < rows.columns; ++c) rows.row(row)[c] *= factor;
}

void solve(const GridRows& rows, std::ptrdiff_t begin, std::ptrdiff_t end, double first, double last,
           bool closed) {
    const auto count = static_cast<std::size_t>(end - begin);
    std::vector<double> diagonal(count, 4.0), off(closed ? count : count - 1, 1.0);
    diagonal.front() = first, diagonal.back() = last;
    TridiagonalSolver(std::move(diagonal), std::move(off), closed)
        .solve(rows.row(begin), rows.columns, rows.stride);
}

void filter_free(const GridRows& rows) {
    const auto last = static_cast<std::ptrdiff_t>(rows.count) - 1;
    if (last < 2) return; // a line
    if (last == 2) {      // a parabola
        const GridRows& r = rows;
        std::vector<double> bend(r.columns);
        for (std::size_t c = 0; c < r.columns; ++c)
            bend[c] = (r.row(0)[c] - 2 * r.row(1)[c] + r.row(2)[c]) / 6;
        for (std::ptrdiff_t i = 0; i <= last; ++i)
            for (std::size_t c = 0; c < r.columns; ++c) r.row(i)[c] -= bend[c];
        return;
    }
    // Rows 1 and last - 1 hold 6 f until the end rows have been made with them: kept in the ghost rows.
    combine(rows, -1, {{1, 6.0}});
    combine(rows, last + 1, {{last - 1, 6.0}});
    combine(rows, -2, {{1, 8.0 / 6}, {0, -1.0 / 6}, {2, -1.0 / 6}});
    combine(rows, last + 2, {{last - 1, 8.0 / 6}, {last, -1.0 / 6}, {last - 2, -1.0 / 6}});
    for (std::ptrdiff_t i = 2; i <= last - 2; ++i) scale(rows, i, 6);
    combine(rows, 1, {{-2, 1.0}});
    combine(rows, last - 1, {{last + 2, 1.0}});
    if (last >= 4) {
        combine(rows, 2, {{2, 1.0}, {1, -1.0}});
        combine(rows, last - 2, {{last - 2, 1.0}, {last - 1, -1.0}});
        solve(rows, 2, last - 1, 4, 4, false);
    }
    combine(rows, 0, {{-1, 1.0}, {1, -4.0}, {2, -1.0}});
    combine(rows, last, {{last + 1, 1.0}, {last - 1, -4.0}, {last - 2, -1.0}});
}

void filter_periodic(const GridRows& rows) {
    const auto count = static_cast<std::ptrdiff_t>(rows.count);
    if (count == 1) return;
    if (count == 2) { // 4 c_i + 2 c_j = 6 f_i
        for (std::size_t c = 0; c < rows.columns; ++c) {
            const double a = rows.row(0)[c], b = rows.row(1)[c];
            rows.row(0)[c] = 2 * a - b, rows.row(1)[c] = 2 * b - a;
        }
        return;
    }
    for (std::ptrdiff_t i = 0; i < count; ++i) scale(rows, i, 6);
    solve(rows, 0, count, 4, 4, true);
}

void filter_reflecting(const GridRows& rows, bool centred) {
    const auto count = static_cast<std::ptrdiff_t>(rows.count);
    if (count == 1) return;
    for (std::ptrdiff_t i = 0; i < count; ++i) scale(rows, i, !centred && (i == 0 || i + 1 == count) ? 3 : 6);
    // Mirrored at a point: 4 c_0 + 2 c_1, halved; between points: 5 c_0 + c_1.
    const double end = centred ? 5 : 2;
    solve(rows, 0, count, end, end, false);
}

/// Extrapolates `to` from the rows to + step, to + 2 step, ...
void extrapolate(const GridRows& rows, std::ptrdiff_t to, std::ptrdiff_t step) {
    const auto at = [&](int k) { return to + k * step; };
    switch (std::min<std::size_t>(rows.count, 4)) {
    case 1:
        return combine(rows, to, {{at(1), 1.0}});
    case 2:
        return combine(rows, to, {{at(1), 2.0}, {at(2), -1.0}});
    case 3:
        return combine(rows, to, {{at(1), 3.0}, {at(2), -3.0}, {at(3), 1.0}});
    default:
        return combine(rows, to, {{at(1), 4.0}, {at(2), -6.0}, {at(3), 4.0}, {at(4), -1.0}});
    }
}

/// The row of the grid whose mirror image row i is.
std::ptrdiff_t mirrored(std::ptrdiff_t i, std::ptrdiff_t count, bool centred) {
    if (count == 1) return 0;
    while (i < 0 || i >= count) {
        if (i < 0) i = centred ? -1 - i : -i;
        if (i >= count) i = centred ? 2 * count - 1 - i : 2 * count - 2 - i;
    }
    return i;
}

} // namespace

void filter_rows(const GridRows& rows, const GridDirection& direction) {
    switch (direction.ends) {
    case GridEnds::free:
        return filter_free(rows);
    case GridEnds::periodic:
        return filter_periodic(rows);
    case GridEnds::reflecting:
        return filter_reflecting(rows, direction.centred);
    case GridEnds::poles:
        GASPARD_CHECK(direction.ends != GridEnds::poles);
    }
}

void extend_rows(const GridRows& rows, const GridDirection& direction) {
    const auto count = static_cast<std::ptrdiff_t>(rows.count);
    for (const std::ptrdiff_t i : {std::ptrdiff_t{-1}, std::ptrdiff_t{-2}, count, count + 1}) {
        if (direction.ends == GridEnds::free)
            extrapolate(rows, i, i < 0 ? 1 : -1);
        else if (direction.ends == GridEnds::periodic)
            combine(rows, i, {{((i % count) + count) % count, 1.0}});
        else
            combine(rows, i, {{mirrored(i, count, direction.centred), 1.0}});
    }
}

void filter_poles(const GridRows& rows) {
    // A great circle through the poles: up along one meridian, down along the opposite one.
    const std::size_t last = rows.count - 1, circle = 2 * last, half = rows.columns / 2;
    const TridiagonalSolver solver(std::vector(circle, 4.0), std::vector(circle, 1.0), true);
    std::vector<double> c(circle * half);
    for (std::size_t j = 0; j < circle; ++j) {
        const double* from =
            j <= last ? rows.first + j * rows.stride : rows.first + (circle - j) * rows.stride + half;
        for (std::size_t i = 0; i < half; ++i) c[j * half + i] = 6 * from[i];
    }
    solver.solve(c.data(), half, half);
    for (std::size_t j = 0; j <= last; ++j) {
        double* to = rows.first + j * rows.stride;
        const double* down = c.data() + ((circle - j) % circle) * half;
        std::copy_n(c.data() + j * half, half, to);
        std::copy_n(down, half, to + half);
    }
}

void extend_poles(const GridRows& rows) {
    const auto last = static_cast<std::ptrdiff_t>(rows.count) - 1;
    const std::size_t half = rows.columns / 2;
    for (std::ptrdiff_t k = 1; k <= 2; ++k)
        for (std::size_t i = 0; i < rows.columns; ++i) {
            const std::size_t opposite = (i + half) % rows.columns;
            rows.row(-k)[i] = rows.row(k)[opposite];
            rows.row(last + k)[i] = rows.row(last - k)[opposite];
        }
}

} // namespace gaspard
