// Interpolation errors against the number of cells: the same problem solved on a row of meshes, each compared
// with the uniform mesh that has as many cells (diagnostics/interpolation_error.hpp).
//
//   order = - log(error / error before) / log(h before / h),   h = (number of cells)^(-1/d)
#pragma once

#include "core/base/export.hpp"
#include "core/diagnostics/interpolation_error.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/session/run.hpp"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

/// The key of the domain's values that says how many cells there are ("cells", "refinements"). Throws
/// InputError if the domain has none.
std::string resolution_key(const Scenario& scenario);
/// Half of the scenario's cells per side, as many, and twice as many (of refinements: one less, as many, one
/// more), as far as the domain allows; not more than 128 cells per side unless the scenario has them.
std::vector<std::int64_t> usual_resolutions(const Scenario& scenario);
/// Numbers from a text such as "15,30,60", ascending. Throws InputError if one is not allowed or is there
/// twice.
std::vector<std::int64_t> parse_resolutions(const Scenario& scenario, std::string_view text);
/// The scenario at another resolution, measured in full with interpolation errors.
Scenario with_resolution(const Catalogue& catalogue, const Scenario& scenario, std::int64_t resolution);

/// Throws InputError if the scenario's meshes have no uniform mesh of the same domain to be compared with.
void check_comparable(const Scenario& scenario);
/// The results at one resolution. Arrays have one entry per ErrorNorm.
struct InterpolationRow {
    std::int64_t resolution = 0; ///< value of resolution_key()
    std::size_t cells = 0;       ///< of the mesh
    int dimension = 2;           ///< of its cells
    RunStatus status = RunStatus::preparing;
    int iterations = 0;
    InterpolationComparison errors;
    /// Between the row before and this one; NaN in the first, and where an error is zero.
    std::array<double, 3> uniform_order{}, adapted_order{};
};
/// The row of a run that has ended; `before`: the row of fewer cells, null in the first.
InterpolationRow interpolation_row(Run& run, const InterpolationRow* before, std::stop_token stop = {});

/// Column headings of the table, and the three lines of a row, one per norm, as text.
std::vector<std::string> interpolation_heads();
std::vector<std::vector<std::string>> interpolation_lines(const InterpolationRow& row);
/// What is to be said of a row: cells that fold, integrals that are not precise; empty if nothing.
std::string interpolation_note(const InterpolationRow& row);

} // namespace GASPARD_API
