#include "core/method/mesh_levels.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

std::vector<ParameterRow> MeshLevels::rows(int start_cells, int inner_solves, int final_solves) {
    return {{.key = "refine",
             .label = "Start coarse",
             .kind = ParameterKind::boolean,
             .default_value = true,
             .help = "starts on a coarse mesh, which is refined (Algorithms 2 and 3); off: Algorithm 1"},
            {.key = "start_cells",
             .label = "Coarsest mesh",
             .kind = ParameterKind::integer,
             .minimum = 1,
             .maximum = 65536,
             .scale = ParameterScale::logarithmic,
             .slider = SliderRange{1, 64},
             .default_value = std::int64_t{start_cells},
             .help = "the coarsest mesh has at least as many cells (per side)"},
            {.key = "inner_solves",
             .label = "Solves per mesh",
             .kind = ParameterKind::integer,
             .minimum = 1,
             .maximum = 1000,
             .slider = SliderRange{1, 20},
             .default_value = std::int64_t{inner_solves},
             .help = "solves on each coarser mesh"},
            {.key = "final_solves",
             .label = "Final solves",
             .kind = ParameterKind::integer,
             .minimum = 0,
             .maximum = 10000,
             .slider = SliderRange{0, 20},
             .default_value = std::int64_t{final_solves},
             .help = "solves on the last mesh; 0: until the residual is below the tolerance"}};
}

void MeshLevels::configure(const Values& values, int cells, bool even) {
    const auto start = static_cast<int>(values.integer("start_cells"));
    if (start > cells)
        throw InputError("method.start_cells (" + std::to_string(start) +
                         ") must not be greater than domain.cells (" + std::to_string(cells) + ")");
    inner_ = static_cast<int>(values.integer("inner_solves"));
    final_ = static_cast<int>(values.integer("final_solves"));
    cells_ = {cells};
    while (values.boolean("refine") && cells_.back() > 1) {
        const int half = (cells_.back() + 1) / 2;
        if (half < start || (even && cells_.back() % 2 != 0)) break;
        cells_.push_back(half);
    }
}

std::size_t MeshLevels::level_of(int cells) const {
    const auto found = std::find(cells_.begin(), cells_.end(), cells);
    return found == cells_.end() ? 0 : static_cast<std::size_t>(found - cells_.begin());
}

std::size_t MeshLevels::next(std::size_t level) {
    std::size_t there = level;
    if (std::exchange(fresh_, false) && level == 0)
        there = coarsest();
    else if (level > 0 && solves_ >= inner_)
        there = level - 1;
    if (there != level) solves_ = 0;
    return there;
}

Ending MeshLevels::ending(std::size_t level) {
    ++solves_;
    if (level > 0) return Ending::not_yet;
    if (final_ == 0) return Ending::by_criterion;
    return solves_ >= final_ ? Ending::complete : Ending::not_yet;
}

} // namespace gaspard
