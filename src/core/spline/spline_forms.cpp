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

SplineForm::Workspace SplineForm::make_workspace() const {
    const std::size_t most = line_.upper.size(), points = line_.points.size();
    Workspace workspace;
    workspace.poisson = poisson_.make_workspace();
    workspace.load.resize(size() * points);
    workspace.turned.resize(most * points);
    return workspace;
}

void SplineForm::sum_along_x(const LineTable& table, int derivative, std::span<const double> coefficients,
                             std::size_t rows, std::vector<double>& half, Workspace& workspace) {
    const std::size_t columns = table.functions(), points = table.points();
    workspace.turned.resize(columns * rows);
    workspace.turned_sum.resize(points * rows);
    half.resize(points * rows);
    transpose(coefficients.data(), columns, workspace.turned.data(), rows, rows, columns);
    table.combine_all(derivative, workspace.turned.data(), rows, workspace.turned_sum.data());
    transpose(workspace.turned_sum.data(), rows, half.data(), points, points, rows);
}

void SplineForm::row(const SplineGrid& grid, std::size_t y, std::size_t fields, const FieldRow& out,
                     const Workspace& workspace) const {
    for (std::size_t f = 0; f < fields; ++f) {
        const auto& [half, upper, derivative] = terms_[f];
        (upper ? grid.upper : grid.lower)
            .combine(derivative, y, workspace.half[half].data(), grid.points.size(), out[f]);
    }
}

void SplineForm::begin_load(Workspace& workspace) const {
    workspace.load.assign(size() * line_.points.size(), 0.0);
}

void SplineForm::load_row(std::size_t y, const double* g, Workspace& workspace) const {
    tests().scatter(0, y, line_.weights[y], g, line_.points.size(), workspace.load.data());
}

void SplineForm::end_load(std::span<double> b, Workspace& workspace) const {
    const std::size_t n = size(), points = line_.points.size();
    workspace.turned.resize(points * n);
    workspace.turned_sum.assign(n * n, 0.0);
    transpose(workspace.load.data(), points, workspace.turned.data(), n, n, points);
    for (std::size_t q = 0; q < points; ++q)
        tests().scatter(0, q, line_.weights[q], &workspace.turned[q * n], n, workspace.turned_sum.data());
    transpose(workspace.turned_sum.data(), n, b.data(), n, n, n);
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

// sqrt(phi^T (M (x) M) phi) for phi without its mean; M is banded.
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
