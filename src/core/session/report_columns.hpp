// Reports as rows of tables: the columns of every file with reports in it, by the names of the series.
#pragma once

#include "core/session/snapshot.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// `always`, then the further series of the reports that are to have a column (SeriesInfo::column), in the
/// order in which they come.
std::vector<std::string> report_columns(std::span<const std::string_view> always,
                                        std::span<const StepReport> history);
/// Adds the further columns of another run.
void add_columns(std::vector<std::string>& columns, std::span<const StepReport> history);

/// The series by which the run ends (MethodType::criterion), where that is not the residual; else null.
const SeriesInfo* other_criterion(const StepReport& report);

/// One cell: of a series, or iteration, tangled_cells, inner_iterations, seconds, cpu_seconds, status, note
/// (quoted for CSV where needed). Empty where there is no value.
std::string report_cell(const StepReport& report, std::string_view column);
/// The columns' names, or the cells of one report, with commas between.
std::string csv_head(const std::vector<std::string>& columns);
std::string csv_row(const StepReport& report, const std::vector<std::string>& columns);

} // namespace gaspard
