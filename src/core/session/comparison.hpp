// Several methods on one problem: which ones can be compared, and the table of what came out.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "core/session/snapshot.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// The methods that go with a scenario's domain, boundary and monitor, in the catalogue's order.
std::vector<std::string> methods_for(const Catalogue& catalogue, const Scenario& scenario);

/// The same problem for another method, to the same tolerance and with as many iterations at most. Its own
/// parameters are the scenario's where that has this very method, else their defaults.
Scenario with_method(const Catalogue& catalogue, const Scenario& scenario, const std::string& method);

/// What one method made of the problem.
struct ComparisonRow {
    std::string method;
    int iterations = 0;
    int inner_iterations = 0; ///< of the linear solver, in all
    double cpu_seconds = 0;   ///< of solving
    double residual = 0;
    std::optional<double> equidistribution{};
    std::optional<std::size_t> tangled_cells{};
    RunStatus status = RunStatus::preparing;
};
/// Of a history; one without rows gives a row without numbers.
ComparisonRow comparison_row(const std::string& method, const std::vector<StepReport>& history);

/// The table's columns: heads, and the cells of a row as texts for people.
std::vector<std::string> comparison_heads();
std::vector<std::string> comparison_cells(const ComparisonRow& row);
/// The table with all digits; names as in `gaspard run`'s files.
std::string comparison_csv(const std::vector<ComparisonRow>& rows);

} // namespace gaspard
