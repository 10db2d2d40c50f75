#include "core/session/report_columns.hpp"

#include "core/base/csv.hpp"
#include "core/base/join.hpp"

#include <algorithm>

namespace gaspard {

std::vector<std::string> report_columns(std::span<const std::string_view> always,
                                        std::span<const StepReport> history) {
    std::vector<std::string> columns(always.begin(), always.end());
    add_columns(columns, history);
    return columns;
}

void add_columns(std::vector<std::string>& columns, std::span<const StepReport> history) {
    const SeriesTable* before = nullptr; // another method brings another table
    for (const StepReport& report : history) {
        if (report.series.get() == before) continue;
        before = report.series.get();
        for (const SeriesInfo& info : before->all())
            if (info.column && std::find(columns.begin(), columns.end(), info.name) == columns.end())
                columns.push_back(info.name);
    }
}

const SeriesInfo* other_criterion(const StepReport& report) {
    const SeriesTable& table = *report.series;
    return table.criterion() == SeriesTable::residual() ? nullptr : &table.all()[table.criterion()];
}

std::string report_cell(const StepReport& report, std::string_view column) {
    if (column == "iteration") return std::to_string(report.iteration);
    if (column == "tangled_cells") return report.tangled_cells ? std::to_string(*report.tangled_cells) : "";
    if (column == "inner_iterations") return std::to_string(report.inner_iterations);
    if (column == "seconds") return format_number(report.seconds);
    if (column == "cpu_seconds") return format_number(report.cpu_seconds);
    if (column == "step_size") return format_number(report.step_size); // 0 at the start
    if (column == "status") return std::string(status_name(report.status));
    if (column == "note") return csv_text(report.note);
    return format_number(report.value(column));
}

std::string csv_head(const std::vector<std::string>& columns) { return join(columns, ","); }

std::string csv_row(const StepReport& report, const std::vector<std::string>& columns) {
    std::vector<std::string> cells;
    for (const std::string& column : columns) cells.push_back(report_cell(report, column));
    return join(cells, ",");
}

} // namespace gaspard
