#include "core/layer/solution_density.hpp"

#include "core/base/error.hpp"
#include "core/layer/square_mesh_pde.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gaspard {

namespace {

using Index = std::size_t;

void check_solution(std::span<const double> x, const IntervalSolution& solution) {
    if (x.size() < 3) throw InputError("a mesh must have three nodes for densities from its solution");
    for (const auto& values : solution.nodes)
        if (values.size() != x.size())
            throw InputError("the solution must have " + std::to_string(x.size()) +
                             " values, one per node, not " + std::to_string(values.size()));
}

std::vector<double> slopes_of(std::span<const double> x, const std::vector<double>& u) {
    std::vector<double> slopes(x.size() - 1);
    for (Index i = 0; i < slopes.size(); ++i) slopes[i] = (u[i + 1] - u[i]) / (x[i + 1] - x[i]);
    return slopes;
}

/// |u''| on cells: the mean of those at its inner nodes, which are differences of slopes.
std::vector<double> curvatures_of(std::span<const double> x, const std::vector<double>& u) {
    const std::vector<double> slopes = slopes_of(x, u);
    std::vector<double> at_nodes(x.size());
    for (Index i = 1; i + 1 < x.size(); ++i)
        at_nodes[i] = 2 * std::abs(slopes[i] - slopes[i - 1]) / (x[i + 1] - x[i - 1]);
    at_nodes.front() = at_nodes[1];
    at_nodes.back() = at_nodes[x.size() - 2];
    std::vector<double> curvatures(slopes.size());
    for (Index i = 0; i < slopes.size(); ++i) curvatures[i] = 0.5 * (at_nodes[i] + at_nodes[i + 1]);
    return curvatures;
}

/// The mean over the interval of a function that is constant on cells.
double mean(std::span<const double> x, const std::vector<double>& values) {
    double sum = 0;
    for (Index i = 0; i < values.size(); ++i) sum += values[i] * (x[i + 1] - x[i]);
    return sum / (x.back() - x.front());
}

/// eta_i^2.
std::vector<double> squared_estimates(const IntervalProblem& problem, std::span<const double> x,
                                      const IntervalSolution& solution) {
    check_solution(x, solution);
    if (solution.nodes.size() != problem.components())
        throw InputError("the solution must have as many components as the problem");
    std::vector<double> squares(x.size() - 1, 0.0);
    for (Index k = 0; k < solution.nodes.size(); ++k) {
        const auto curvatures = curvatures_of(x, solution.nodes[k]);
        for (Index i = 0; i < squares.size(); ++i) {
            const double h = x[i + 1] - x[i];
            squares[i] += (problem.diffusion[k] / 12 + h * h / 120) * h * std::pow(h * curvatures[i], 2);
        }
    }
    return squares;
}

/// Constant on each cell.
class CellMonitor : public Monitor {
  public:
    CellMonitor(std::vector<double> x, std::vector<double> densities)
        : x_(std::move(x)), densities_(std::move(densities)) {}
    void values(const Points& at, std::span<double> rho) const override {
        for (Index i = 0; i < rho.size(); ++i) {
            const auto after = std::upper_bound(x_.begin() + 1, x_.end() - 1, at.x[i]);
            rho[i] = densities_[static_cast<Index>(after - x_.begin()) - 1];
        }
    }

  private:
    std::vector<double> x_, densities_;
};

} // namespace

std::vector<double> arc_length_densities(std::span<const double> x, const IntervalSolution& solution) {
    check_solution(x, solution);
    std::vector<double> squares(x.size() - 1, 1.0);
    for (const auto& u : solution.nodes) {
        std::vector<double> slopes = slopes_of(x, u);
        for (double& slope : slopes) slope = std::abs(slope);
        const double scale = mean(x, slopes);
        if (scale > 0)
            for (Index i = 0; i < squares.size(); ++i) squares[i] += std::pow(slopes[i] / scale, 2);
    }
    for (double& value : squares) value = std::sqrt(value);
    return squares;
}

std::vector<double> curvature_densities(std::span<const double> x, const IntervalSolution& solution,
                                        double k) {
    check_solution(x, solution);
    if (!(k >= 1)) throw InputError("k must be at least 1");
    std::vector<double> sums(x.size() - 1, 1.0);
    for (const auto& u : solution.nodes) {
        std::vector<double> powers = curvatures_of(x, u);
        for (double& value : powers) value = std::pow(value, 2 / k);
        const double scale = mean(x, powers);
        if (scale > 0)
            for (Index i = 0; i < sums.size(); ++i) sums[i] += std::pow(powers[i] / scale, k);
    }
    for (double& value : sums) value = std::pow(value, 1 / k);
    return sums;
}

std::vector<double> estimate_densities(const IntervalProblem& problem, std::span<const double> x,
                                       const IntervalSolution& solution) {
    std::vector<double> densities = squared_estimates(problem, x, solution);
    for (Index i = 0; i < densities.size(); ++i) densities[i] = std::cbrt(densities[i]) / (x[i + 1] - x[i]);
    const double scale = mean(x, densities);
    for (double& density : densities) density = scale > 0 ? 1 + density / scale : 1;
    return densities;
}

double estimated_error(const IntervalProblem& problem, std::span<const double> x,
                       const IntervalSolution& solution) {
    const auto squares = squared_estimates(problem, x, solution);
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
}

std::vector<double> smoothed_densities(std::vector<double> densities, int times) {
    std::vector<double> from;
    for (int k = 0; k < times; ++k) {
        from = densities;
        for (Index i = 0; i < from.size(); ++i)
            densities[i] =
                0.25 * (from[i > 0 ? i - 1 : 0] + 2 * from[i] + from[std::min(i + 1, from.size() - 1)]);
    }
    return densities;
}

std::shared_ptr<const Monitor> cell_monitor(std::vector<double> x, std::vector<double> densities) {
    if (x.size() < 2 || densities.size() + 1 != x.size())
        throw InputError("a monitor of cells must have a density per cell");
    return std::make_shared<CellMonitor>(std::move(x), std::move(densities));
}

static std::vector<double> densities_of(SolutionDensity density, const IntervalProblem& problem,
                                        std::span<const double> x, const IntervalSolution& solution) {
    switch (density) {
    case SolutionDensity::arc_length:
        return arc_length_densities(x, solution);
    case SolutionDensity::curvature:
        return curvature_densities(x, solution);
    case SolutionDensity::estimate:
        return estimate_densities(problem, x, solution);
    }
    throw InputError("unknown density");
}

std::vector<double> solution_densities(const SolutionMeshOptions& options, const IntervalProblem& problem,
                                       std::span<const double> x, const IntervalSolution& solution) {
    return smoothed_densities(densities_of(options.density, problem, x, solution), options.smoothing);
}

std::vector<double> mesh_from_solution(const IntervalProblem& problem, Interval interval, int cells,
                                       const SolutionMeshOptions& options) {
    if (options.start_cells < 4) throw InputError("the coarsest mesh must have at least 4 cells");
    std::vector<double> x = uniform_interval(interval, coarsest_cells(cells, options.start_cells));
    for (;;) {
        for (int k = 0; k < options.steps; ++k) {
            const auto solution = solve_fitted(problem, x);
            x = next_interval_mesh(solution_densities(options, problem, x, solution), interval);
        }
        if (x.size() > static_cast<Index>(cells)) return x;
        x = refined_interval(x);
    }
}

} // namespace gaspard
