// Interpolation errors as text: the table of `gaspard why` as CSV, JSON and plot, the errors of a run as
// JSON.
#pragma once

#include "core/session/interpolation_study.hpp"
#include "core/tessellate/plot.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace gaspard {

/// "uniform", "adapted" and "ratio" with one number per norm, which is null where it is not a number; for
/// both meshes the relative uncertainty and the number of tangled cells.
nlohmann::ordered_json interpolation_json(const InterpolationComparison& errors);

/// One line per number of cells and norm.
std::string why_csv(const std::vector<InterpolationRow>& rows);
/// With the names of the scenario and its modified keys, as summary.json has them.
std::string why_json(const Scenario& scenario, const std::vector<InterpolationRow>& rows);
/// All errors against the number of cells.
Plot why_plot(const std::vector<InterpolationRow>& rows);

} // namespace gaspard
