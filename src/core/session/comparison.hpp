// Comparison of several methods on one problem: the applicable methods, and the table of results.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "core/session/snapshot.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// The methods that can be combined with the scenario's domain, boundary and monitor, in catalogue order.
std::vector<std::string> methods_for(const Catalogue& catalogue, const Scenario& scenario);

/// The same problem with another method and the same common_method_rows() values (tolerance, max_iterations,
/// ...). The other parameters of the method have default values, unless it is the method of the scenario.
Scenario with_method(const Catalogue& catalogue, const Scenario& scenario, const std::string& method);

/// The results of one method.
struct ComparisonRow {
    std::string method;
    int iterations = 0;        ///< on all meshes, and in all time steps
    int coarse_iterations = 0; ///< of these, updates made on coarser meshes, before the first time step
    int inner_iterations = 0;  ///< total iterations of the linear solver
    double cpu_seconds = 0;    ///< CPU time of the iteration
    double residual = 0;       ///< on the mesh of the run; the same measure for all methods
    /// The series by which the method ends (MethodType::criterion), and its last value.
    std::string criterion = "residual";
    double criterion_value = 0;
    std::optional<double> equidistribution{};
    std::optional<std::size_t> tangled_cells{};
    RunStatus status = RunStatus::preparing;
};
/// The row for the history of a run; an empty history gives a row with status preparing.
ComparisonRow comparison_row(const std::string& method, const std::vector<StepReport>& history);

/// The reports whose residuals can be compared, those on the mesh of the run: the start, and each update made
/// there. `iteration` counts these updates; coarser meshes are left out.
struct FinestReport {
    int iteration = 0;
    const StepReport* report; ///< of the history
};
std::vector<FinestReport> finest_reports(const std::vector<StepReport>& history);
/// Those that curves show, and where on the horizontal axis: all, at their `iteration`; of a scenario with
/// time the solved start and the time steps, at their times.
struct ComparisonPoint {
    double x = 0;
    const StepReport* report; ///< of the history
};
std::vector<ComparisonPoint> comparison_points(const Scenario& scenario,
                                               const std::vector<StepReport>& history);
/// "iteration on the finest mesh" or "time t".
std::string comparison_axis(const Scenario& scenario);

/// Column headings of the table, and the cells of a row as text.
std::vector<std::string> comparison_heads();
std::vector<std::string> comparison_cells(const ComparisonRow& row);
/// The table as CSV with all digits; column names as in the files of `gaspard run`.
std::string comparison_csv(const std::vector<ComparisonRow>& rows);

} // namespace gaspard
