#include "core/layer/square_mesh_pde.hpp"

#include "core/base/error.hpp"
#include "core/layer/square_level.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

using Index = std::size_t;

int coarsest_cells(int cells, int start_cells) {
    if (start_cells < 1 || cells < start_cells)
        throw InputError("the number of cells, " + std::to_string(cells) + ", must be at least " +
                         std::to_string(std::max(start_cells, 1)) + ", that of the coarsest mesh");
    while (cells % 2 == 0 && cells / 2 >= start_cells) cells /= 2;
    return cells;
}

SquareMeshPde::SquareMeshPde(MeshPdeForm form, DensitySamples samples, const std::array<Vec3, 4>& corners,
                             int cells) {
    if (cells < 1) throw InputError("the number of cells, " + std::to_string(cells) + ", must be at least 1");
    level_ = std::make_unique<SquareLevel>(cells, form, samples, corners);
}
SquareMeshPde::~SquareMeshPde() = default;
SquareMeshPde::SquareMeshPde(SquareMeshPde&&) noexcept = default;
SquareMeshPde& SquareMeshPde::operator=(SquareMeshPde&&) noexcept = default;

int SquareMeshPde::cells() const { return level_->n(); }
const Points& SquareMeshPde::nodes() const { return level_->nodes(); }
const Points& SquareMeshPde::centres() const { return level_->centres(); }
SquareMeshSolve SquareMeshPde::solve(const LayerDensities& densities) { return level_->solve(densities); }
SquareMeshSolve SquareMeshPde::solve(TriangleDensities densities) {
    for (const auto& m : densities) {
        if (m.size() != 4 * level_->centres().size())
            throw InputError("the mesh has " + std::to_string(4 * level_->centres().size()) +
                             " triangles, not " + std::to_string(m.size()));
        for (const double value : m)
            if (!(value > 0) || !std::isfinite(value))
                throw InputError("the density of the mesh must be positive and finite");
    }
    return level_->solve(std::move(densities));
}
SquareMeshNewton SquareMeshPde::newton(const LayerDensities& densities, const std::stop_token& stop) {
    return level_->newton(densities, stop);
}
void SquareMeshPde::refine() { *level_ = level_->refined(); }

static void check_positions(const Points& x, Index count, const char* what) {
    if (x.size() != count)
        throw InputError("the mesh has " + std::to_string(count) + ' ' + what + ", not " +
                         std::to_string(x.size()));
    for (Index i = 0; i < count; ++i)
        if (!std::isfinite(x.x[i]) || !std::isfinite(x.y[i]))
            throw InputError("the positions of the " + std::string(what) + " must be finite");
}

void SquareMeshPde::set_positions(Points nodes, Points centres) {
    check_positions(nodes, level_->nodes().size(), "nodes");
    check_positions(centres, level_->centres().size(), "centres");
    level_->restore_fixed(nodes);
    level_->set_positions(std::move(nodes), std::move(centres));
}

void SquareMeshPde::set_positions(Points nodes) {
    check_positions(nodes, level_->nodes().size(), "nodes");
    level_->restore_fixed(nodes);
    Points centres(level_->centres().size());
    const auto n = static_cast<Index>(cells());
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
            const Index p = j * (n + 1) + i;
            centres.set(j * n + i, 0.25 * (nodes[p] + nodes[p + 1] + nodes[p + n + 1] + nodes[p + n + 2]));
        }
    level_->set_positions(std::move(nodes), std::move(centres));
}

SquareMeshPdeResult mesh_pde_square(const LayerDensities& densities, int cells,
                                    const SquareMeshPdeOptions& options) {
    SquareMeshPdeResult result;
    SquareMeshPde pde(options.form, options.samples, options.corners,
                      coarsest_cells(cells, options.start_cells));
    while (pde.cells() < cells) {
        for (int i = 0; i < options.inner; ++i)
            result.inner_iterations += pde.solve(densities).inner_iterations;
        pde.refine();
    }
    for (int i = 0; i < options.final; ++i) {
        const auto solve = pde.solve(densities);
        result.updates.push_back(solve.update);
        result.inner_iterations += solve.inner_iterations;
        if (solve.update <= options.tolerance) break;
    }
    result.x = pde.nodes();
    return result;
}

SquareConvergence converge_square(SquareMeshPde& pde, const LayerDensities& densities, double tolerance,
                                  int max_steps) {
    SquareConvergence result;
    while (result.steps < max_steps && !result.converged) {
        const auto step = pde.newton(densities);
        ++result.steps;
        result.update = step.update, result.residual = step.residual;
        result.converged = step.converged(tolerance);
    }
    return result;
}

std::size_t inverted_triangles(const Points& x, int cells) {
    const auto s = static_cast<Index>(cells + 1);
    std::size_t count = 0;
    const auto inverted = [&](Index a, Index b, Index c) {
        return !((x.x[b] - x.x[a]) * (x.y[c] - x.y[a]) - (x.x[c] - x.x[a]) * (x.y[b] - x.y[a]) > 0);
    };
    for (Index j = 0; j + 1 < s; ++j)
        for (Index i = 0; i + 1 < s; ++i) {
            const Index p = j * s + i;
            count += (inverted(p, p + 1, p + s + 1) ? 1U : 0U) + (inverted(p, p + s + 1, p + s) ? 1U : 0U);
        }
    return count;
}

} // namespace gaspard
