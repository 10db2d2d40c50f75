#include "core/spline/spline_forms.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"
#include "core/linear/transpose.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

SplineLine::SplineLine(KnotVector space) : upper(std::move(space)), lower(derivative_space(upper)) {
    const auto breaks = upper.breaks();
    const LineQuadrature rule = gauss_legendre(upper.degree + 1);
    for (std::size_t c = 0; c + 1 < breaks.size(); ++c)
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            points.push_back(breaks[c] + (breaks[c + 1] - breaks[c]) * rule.points[q]);
            weights.push_back((breaks[c + 1] - breaks[c]) * rule.weights[q]);
        }
}

NormalTrace identity_trace(const SplineLine& line) {
    const std::vector<double> zero(line.points.size(), 0.0), one(line.points.size(), 1.0);
    return {zero, one, zero, one};
}

double flux(const SplineLine& line, const NormalTrace& trace) {
    double sum = 0;
    for (std::size_t q = 0; q < line.points.size(); ++q)
        sum += line.weights[q] * (trace.right[q] - trace.left[q] + trace.top[q] - trace.bottom[q]);
    return sum;
}

SplineForm::Room SplineForm::make_room() const {
    const std::size_t most = line_.upper.size(), points = line_.points.size();
    Room room;
    room.poisson = poisson_.make_room();
    room.load.resize(size() * points);
    room.turned.resize(most * points);
    return room;
}

void SplineForm::sum_along_x(const LineTable& table, int derivative, std::span<const double> coefficients,
                             std::size_t rows, std::vector<double>& half, Room& room) {
    const std::size_t columns = table.functions(), points = table.points();
    room.turned.resize(columns * rows);
    room.turned_sum.resize(points * rows);
    half.resize(points * rows);
    transpose(coefficients.data(), columns, room.turned.data(), rows, rows, columns);
    table.combine_all(derivative, room.turned.data(), rows, room.turned_sum.data());
    transpose(room.turned_sum.data(), rows, half.data(), points, points, rows);
}

void SplineForm::row(const SplineGrid& grid, std::size_t y, std::size_t fields, const FieldRow& out,
                     const Room& room) const {
    for (std::size_t f = 0; f < fields; ++f) {
        const auto& [half, upper, derivative] = terms_[f];
        (upper ? grid.upper : grid.lower)
            .combine(derivative, y, room.half[half].data(), grid.points.size(), out[f]);
    }
}

void SplineForm::begin_load(Room& room) const { room.load.assign(size() * line_.points.size(), 0.0); }

void SplineForm::load_row(std::size_t y, const double* g, Room& room) const {
    tests().scatter(0, y, line_.weights[y], g, line_.points.size(), room.load.data());
}

void SplineForm::end_load(std::span<double> b, Room& room) const {
    const std::size_t n = size(), points = line_.points.size();
    room.turned.resize(points * n);
    room.turned_sum.assign(n * n, 0.0);
    transpose(room.load.data(), points, room.turned.data(), n, n, points);
    for (std::size_t q = 0; q < points; ++q)
        tests().scatter(0, q, line_.weights[q], &room.turned[q * n], n, room.turned_sum.data());
    transpose(room.turned_sum.data(), n, b.data(), n, n, n);
}

double SplineForm::mean(std::span<const double> phi) const {
    const std::size_t n = size();
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
        double line = 0;
        for (std::size_t i = 0; i < n; ++i) line += integrals_[i] * phi[j * n + i];
        sum += integrals_[j] * line;
    }
    return sum;
}

// phi^T (M (x) M) phi, M banded.
double SplineForm::norm_without_mean(std::span<const double> phi) const {
    const std::size_t n = size(), band = static_cast<std::size_t>(space().degree);
    const double average = mean(phi);
    const double* m = poisson_.mass().entries.data();
    std::vector<double> lines(n * n, 0.0), line(n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = j < band ? 0 : j - band; k < std::min(n, j + band + 1); ++k)
            for (std::size_t i = 0; i < n; ++i) lines[j * n + i] += m[j * n + k] * (phi[k * n + i] - average);
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
        std::fill(line.begin(), line.end(), 0.0);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = i < band ? 0 : i - band; k < std::min(n, i + band + 1); ++k)
                line[i] += m[i * n + k] * (phi[j * n + k] - average);
        for (std::size_t i = 0; i < n; ++i) sum += line[i] * lines[j * n + i];
    }
    return std::sqrt(std::max(sum, 0.0));
}

} // namespace gaspard
