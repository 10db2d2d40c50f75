#include "core/layer/interval_mesh.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gaspard {

std::vector<double> uniform_interval(Interval interval, int cells) {
    std::vector<double> x(static_cast<std::size_t>(cells) + 1);
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = interval.a + (interval.b - interval.a) * static_cast<double>(i) / cells;
    x.back() = interval.b;
    return x;
}

std::vector<double> refined_interval(std::span<const double> x) {
    std::vector<double> fine(2 * x.size() - 1);
    for (std::size_t i = 0; i < x.size(); ++i) fine[2 * i] = x[i];
    for (std::size_t i = 1; i < x.size(); ++i) fine[2 * i - 1] = x[i - 1] + 0.5 * (x[i] - x[i - 1]);
    return fine;
}

std::vector<double> cell_densities(const Monitor& rho, std::span<const double> x) {
    Points points(2 * x.size() - 1);
    points.x = refined_interval(x);
    std::vector<double> at(points.size());
    rho.values(points, at);
    for (std::size_t i = 0; i < at.size(); ++i)
        if (!(at[i] > 0) || !std::isfinite(at[i]))
            throw InputError("the density of the mesh must be positive and finite, but is " +
                             exact_number(at[i]) + " at " + exact_number(points.x[i]));
    std::vector<double> densities(x.size() - 1);
    for (std::size_t i = 0; i < densities.size(); ++i)
        densities[i] = at[2 * i] / 6 + at[2 * i + 1] * (2.0 / 3) + at[2 * i + 2] / 6;
    return densities;
}

std::vector<double> next_interval_mesh(std::span<const double> densities, Interval interval) {
    // Partial sums from both ends, so that cells keep their digits at either end.
    std::vector<double> width(densities.size());
    for (std::size_t i = 0; i < width.size(); ++i) width[i] = 1 / densities[i];
    const double scale = (interval.b - interval.a) / std::accumulate(width.begin(), width.end(), 0.0);
    std::vector<double> x(width.size() + 1, interval.a);
    double sum = 0;
    for (std::size_t i = 0; i < width.size(); ++i) x[i + 1] = interval.a + scale * (sum += width[i]);
    x.back() = interval.b;
    sum = 0;
    for (std::size_t i = width.size(); i-- > 1;) {
        sum += width[i];
        if (2 * scale * sum > interval.b - interval.a) break;
        x[i] = interval.b - scale * sum;
    }
    return x;
}

double interval_residual(std::span<const double> densities, std::span<const double> x) {
    const std::size_t n = densities.size();
    const auto cells = static_cast<double>(n);
    double square = 0, left = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double right =
            i + 1 == n
                ? 0
                : cells * (densities[i] * (x[i + 1] - x[i]) - densities[i + 1] * (x[i + 2] - x[i + 1]));
        square += (left * left + left * right + right * right) / (3 * cells);
        left = right;
    }
    return std::sqrt(square);
}

double worst_share(std::span<const double> densities, std::span<const double> x) {
    double most = 0, sum = 0;
    for (std::size_t i = 0; i < densities.size(); ++i) {
        const double share = densities[i] * (x[i + 1] - x[i]);
        most = std::max(most, share), sum += share;
    }
    return most * static_cast<double>(densities.size()) / sum;
}

static bool is_doubled(int start, int cells) {
    while (start < cells) start *= 2;
    return start == cells;
}

MeshPdeResult mesh_pde_interval(const Monitor& rho, Interval interval, int cells,
                                const MeshPdeOptions& options) {
    if (options.start_cells < 1 || !is_doubled(options.start_cells, cells))
        throw InputError("the number of cells, " + std::to_string(cells) + ", must be " +
                         std::to_string(options.start_cells) + " (the coarsest mesh) times a power of two");
    MeshPdeResult result{.x = uniform_interval(interval, options.start_cells)};
    std::vector<double>& x = result.x;
    while (x.size() <= static_cast<std::size_t>(cells)) {
        for (int i = 0; i < options.inner; ++i) x = next_interval_mesh(cell_densities(rho, x), interval);
        x = refined_interval(x);
    }
    std::vector<double> densities = cell_densities(rho, x);
    do {
        x = next_interval_mesh(densities, interval);
        densities = cell_densities(rho, x);
        result.residual = interval_residual(densities, x);
        result.converged = result.residual <= options.tolerance;
        ++result.iterations;
    } while (!result.converged && result.iterations < options.max_iterations);
    return result;
}

} // namespace gaspard
