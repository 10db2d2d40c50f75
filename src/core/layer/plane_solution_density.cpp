#include "core/layer/plane_solution_density.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

using Index = std::size_t;

/// Densities by lines and cells of lines.
using Lines = std::vector<std::vector<double>>;

/// Empty where the solution does not change along the line.
std::vector<double> line_densities(SolutionDensity density, const std::vector<double>& x,
                                   std::vector<double> u) {
    if (std::all_of(u.begin(), u.end(), [&](double value) { return value == u.front(); })) return {};
    const IntervalSolution solution{.order = 1, .nodes = {std::move(u)}, .middles = {}};
    constexpr double k = 4; // a layer has the same share of the cells, however thin it is
    return density == SolutionDensity::curvature ? curvature_densities(x, solution, k)
                                                 : arc_length_densities(x, solution);
}

/// Gives lines without densities those of the nearest line that has some.
void fill_empty(Lines& lines) {
    const Lines known = lines;
    const Index count = lines.size();
    for (Index j = 0; j < count; ++j)
        for (Index distance = 1; lines[j].empty() && distance < count; ++distance)
            if (j + distance < count && !known[j + distance].empty())
                lines[j] = known[j + distance];
            else if (distance <= j && !known[j - distance].empty())
                lines[j] = known[j - distance];
    for (auto& line : lines)
        if (line.empty()) line.assign(count - 1, 1.0);
}

/// (1, 2, 1) / 4 over neighbours, along the lines and across them.
void smooth(Lines& lines, int times) {
    for (auto& line : lines) line = smoothed_densities(std::move(line), times);
    std::vector<double> across(lines.size());
    for (Index i = 0; i + 1 < lines.size(); ++i) {
        for (Index j = 0; j < lines.size(); ++j) across[j] = lines[j][i];
        across = smoothed_densities(std::move(across), times);
        for (Index j = 0; j < lines.size(); ++j) lines[j][i] = across[j];
    }
}

} // namespace

TriangleDensities plane_solution_densities(const SolutionMeshOptions& options, const Points& parameters,
                                           int cells, const TriangleSolution& solution) {
    const auto n = static_cast<Index>(std::max(cells, 0));
    if (n < 2 || parameters.size() != (n + 1) * (n + 1) || solution.values.size() != parameters.size())
        throw InputError("densities from a solution need its values at the nodes of 2 x 2 cells or more");
    if (options.density == SolutionDensity::estimate)
        throw InputError("in two dimensions, densities are from arc length or curvature");
    TriangleDensities densities;
    for (const Index axis : {Index{0}, Index{1}}) {
        const std::vector<double>& coordinates = axis == 0 ? parameters.x : parameters.y;
        Lines lines(n + 1);
        for (Index line = 0; line <= n; ++line) {
            std::vector<double> x(n + 1), u(n + 1);
            for (Index k = 0; k <= n; ++k) {
                const Index node = axis == 0 ? line * (n + 1) + k : k * (n + 1) + line;
                x[k] = coordinates[node], u[k] = solution.values[node];
            }
            lines[line] = line_densities(options.density, x, std::move(u));
        }
        fill_empty(lines);
        smooth(lines, options.smoothing);
        densities[axis].resize(4 * n * n);
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i < n; ++i) {
                const double mean =
                    axis == 0 ? 0.5 * (lines[j][i] + lines[j + 1][i]) : 0.5 * (lines[i][j] + lines[i + 1][j]);
                std::fill_n(densities[axis].begin() + static_cast<std::ptrdiff_t>(4 * (j * n + i)), 4, mean);
            }
    }
    return densities;
}

} // namespace gaspard
