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

template <std::size_t D>
FaceTrace<D> identity_trace(const SplineLine& line) {
    const std::size_t face = tensor_size<D - 1>(line.points.size());
    FaceTrace<D> trace;
    trace.low.fill(std::vector<double>(face, 0.0));
    trace.high.fill(std::vector<double>(face, 1.0));
    return trace;
}

template <std::size_t D>
double flux(const SplineLine& line, const FaceTrace<D>& trace) {
    const std::size_t points = line.points.size();
    double sum = 0;
    for (std::size_t q = 0; q < tensor_size<D - 1>(points); ++q) {
        double weight = line.weights[q % points], through = 0;
        for (std::size_t rest = q / points, d = 2; d < D; ++d, rest /= points)
            weight *= line.weights[rest % points];
        for (std::size_t d = 0; d < D; ++d) through += trace.high[d][q] - trace.low[d][q];
        sum += weight * through;
    }
    return sum;
}

template <std::size_t D>
typename TensorForm<D>::Workspace TensorForm<D>::make_workspace(std::size_t workers) const {
    Workspace workspace;
    workspace.team = std::make_unique<Team>(D == 3 ? workers : 1);
    workspace.poisson = poisson_.make_workspace();
    workspace.load.resize(size() * slab());
    workspace.turned.resize(workspace.team->workers());
    return workspace;
}

// Arrays of which x runs fastest are lines along x; sums act on lines along another direction, so that a sum
// along x is one along y of the transposed array.
using Turned = std::array<std::vector<double>, 3>;

/// out = the sum along x of `rows` rows of coefficients.
static void sum_along_x(const LineTable& table, int derivative, const double* coefficients, std::size_t rows,
                        double* out, Turned& turned) {
    const std::size_t columns = table.functions(), points = table.points();
    turned[0].resize(columns * rows);
    turned[1].resize(points * rows);
    transpose(coefficients, columns, turned[0].data(), rows, rows, columns);
    table.combine_all(derivative, turned[0].data(), rows, turned[1].data());
    transpose(turned[1].data(), rows, out, points, points, rows);
}

template <std::size_t D>
void TensorForm<D>::sum_halves(const std::array<bool, halves>& wanted,
                               const std::array<std::span<const double>, D>& from, const SplineGrid& grid,
                               Workspace& workspace) const {
    const auto table = [&](const LineSum& sum) -> const LineTable& {
        return sum.upper ? grid.upper : grid.lower;
    };
    const std::size_t points = grid.points.size();
    if constexpr (D == 2) {
        for (std::size_t h = 0; h < halves; ++h) {
            if (!wanted[h]) continue;
            const auto& [component, sums] = halves_[h];
            const LineTable& along_x = table(sums[0]);
            const std::size_t rows = from[component].size() / along_x.functions();
            workspace.half[h].resize(rows * points);
            sum_along_x(along_x, sums[0].derivative, from[component].data(), rows, workspace.half[h].data(),
                        workspace.turned[0]);
        }
    } else {
        std::size_t planes = 0; // the most functions along z
        for (std::size_t h = 0; h < halves; ++h) {
            if (!wanted[h]) continue;
            const auto& [component, sums] = halves_[h];
            const std::size_t plane = table(sums[0]).functions() * table(sums[1]).functions();
            const std::size_t count = from[component].size() / plane;
            workspace.half[h].resize(count * points * points);
            planes = std::max(planes, count);
        }
        workspace.team->share(planes, [&](std::size_t worker, std::size_t begin, std::size_t end) {
            Turned& turned = workspace.turned[worker];
            for (std::size_t z = begin; z < end; ++z) {
                const Half* last = nullptr; // whose sum along x is in turned[2]
                for (std::size_t h = 0; h < halves; ++h) {
                    const auto& [component, sums] = halves_[h];
                    const LineTable &along_x = table(sums[0]), &along_y = table(sums[1]);
                    const std::size_t rows = along_y.functions(), plane = along_x.functions() * rows;
                    if (!wanted[h] || (z + 1) * plane > from[component].size()) continue;
                    if (!last || last->component != component || last->sums[0] != sums[0]) {
                        turned[2].resize(rows * points);
                        sum_along_x(along_x, sums[0].derivative, &from[component][z * plane], rows,
                                    turned[2].data(), turned);
                        last = &halves_[h];
                    }
                    along_y.combine_all(sums[1].derivative, turned[2].data(), points,
                                        &workspace.half[h][z * points * points]);
                }
            }
        });
    }
}

template <std::size_t D>
void TensorForm<D>::expand(std::span<const double> phi, Border border, const SplineGrid& grid,
                           std::size_t count, Workspace& workspace) const {
    std::array<bool, halves> wanted{};
    for (std::size_t f = 0; f < count; ++f) wanted[terms_[f].half] = true;
    sum_halves(wanted, components(phi, border, workspace), grid, workspace);
}

template <std::size_t D>
void TensorForm<D>::row(const SplineGrid& grid, std::size_t at, std::size_t count, const Fields& out,
                        const Workspace& workspace) const {
    const std::size_t length = tensor_size<D - 1>(grid.points.size());
    for (std::size_t f = 0; f < count; ++f) {
        const auto& [half, sum] = terms_[f];
        (sum.upper ? grid.upper : grid.lower)
            .combine(sum.derivative, at, workspace.half[half].data(), length, out[f]);
    }
}

template <std::size_t D>
void TensorForm<D>::begin_load(Workspace& workspace) const {
    workspace.load.assign(size() * slab(), 0.0);
}

template <std::size_t D>
void TensorForm<D>::load_row(std::size_t at, const double* g, Workspace& workspace) const {
    tests().scatter(0, at, line_.weights[at], g, slab(), workspace.load.data());
}

/// b = the integrals along x of `rows` rows at quadrature points against the functions of `tests`.
static void load_along_x(const LineTable& tests, std::span<const double> weights, const double* in,
                         std::size_t rows, double* b, Turned& turned) {
    const std::size_t n = tests.functions(), points = tests.points();
    turned[0].resize(points * rows);
    turned[1].assign(n * rows, 0.0);
    transpose(in, points, turned[0].data(), rows, rows, points);
    for (std::size_t q = 0; q < points; ++q)
        tests.scatter(0, q, weights[q], &turned[0][q * rows], rows, turned[1].data());
    transpose(turned[1].data(), rows, b, n, n, rows);
}

template <std::size_t D>
void TensorForm<D>::end_load(std::span<double> b, Workspace& workspace) const {
    const std::size_t n = size(), points = line_.points.size();
    if constexpr (D == 2)
        load_along_x(tests(), line_.weights, workspace.load.data(), n, b.data(), workspace.turned[0]);
    else
        workspace.team->share(n, [&](std::size_t worker, std::size_t begin, std::size_t end) {
            Turned& turned = workspace.turned[worker];
            for (std::size_t z = begin; z < end; ++z) {
                turned[2].assign(n * points, 0.0);
                const double* plane = &workspace.load[z * points * points];
                for (std::size_t q = 0; q < points; ++q)
                    tests().scatter(0, q, line_.weights[q], plane + q * points, points, turned[2].data());
                load_along_x(tests(), line_.weights, turned[2].data(), n, &b[z * n * n], turned);
            }
        });
}

template <std::size_t D>
double TensorForm<D>::mean(std::span<const double> phi) const {
    const std::size_t n = size();
    double sum = 0;
    for (std::size_t k = 0; k < (D == 3 ? n : 1); ++k) {
        double plane = 0;
        for (std::size_t j = 0; j < n; ++j) {
            double line = 0;
            for (std::size_t i = 0; i < n; ++i) line += integrals_[i] * phi[(k * n + j) * n + i];
            plane += integrals_[j] * line;
        }
        sum += (D == 3 ? integrals_[k] : 1) * plane;
    }
    return sum;
}

/// out = the banded matrix along the direction with this stride, of phi - average.
static void multiply_along(const double* matrix, std::size_t n, std::size_t band, std::size_t stride,
                           std::span<const double> phi, double average, std::span<double> out) {
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t first = 0; first < phi.size(); first += n * stride)
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = j < band ? 0 : j - band; k < std::min(n, j + band + 1); ++k) {
                const double* in = &phi[first + k * stride];
                double* __restrict to = &out[first + j * stride];
                for (std::size_t i = 0; i < stride; ++i) to[i] += matrix[j * n + k] * (in[i] - average);
            }
}

// sqrt(v^T (M (x) M) v) for v = phi without its mean, as (M (x) 1) v times (1 (x) M) v; M is banded.
template <std::size_t D>
double TensorForm<D>::norm_without_mean(std::span<const double> phi) const {
    const std::size_t n = size(), band = static_cast<std::size_t>(space().degree);
    const double average = mean(phi);
    const double* m = poisson_.mass().entries.data();
    std::vector<double> lines(phi.size()), along(D == 3 ? phi.size() : 0), line(n);
    multiply_along(m, n, band, tensor_size<D - 1>(n), phi, average, lines);
    if constexpr (D == 3) {
        multiply_along(m, n, band, n, lines, 0, along);
        lines.swap(along);
    }
    double sum = 0;
    for (std::size_t first = 0; first < phi.size(); first += n) {
        std::fill(line.begin(), line.end(), 0.0);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = i < band ? 0 : i - band; k < std::min(n, i + band + 1); ++k)
                line[i] += m[i * n + k] * (phi[first + k] - average);
        for (std::size_t i = 0; i < n; ++i) sum += line[i] * lines[first + i];
    }
    return std::sqrt(std::max(sum, 0.0));
}

template FaceTrace<2> identity_trace<2>(const SplineLine&);
template FaceTrace<3> identity_trace<3>(const SplineLine&);
template double flux<2>(const SplineLine&, const FaceTrace<2>&);
template double flux<3>(const SplineLine&, const FaceTrace<3>&);
template class TensorForm<2>;
template class TensorForm<3>;

} // namespace gaspard
