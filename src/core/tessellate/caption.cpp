#include "core/tessellate/caption.hpp"

#include "core/session/report_columns.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/ticks.hpp"

namespace gaspard {

std::vector<std::string> caption_parts(const std::string& subject, const StepReport& report,
                                       int last_iteration) {
    std::vector<std::string> parts;
    if (!subject.empty()) parts.push_back(subject);
    if (const auto time = time_of(report)) parts.push_back("t = " + short_number(*time, 5));
    const bool earlier = report.iteration < last_iteration;
    if (!is_time_step(report))
        parts.push_back("iteration " + std::to_string(report.iteration) +
                        (earlier ? " of " + std::to_string(last_iteration) : ""));
    parts.push_back("residual " + short_number(report.residual, 3));
    if (const SeriesInfo* criterion = other_criterion(report))
        if (const auto value = report.value(criterion->name))
            parts.push_back(criterion->name + " " + short_number(*value, 3));
    if (const auto value = report.value("equidistribution"))
        parts.push_back("equidistribution " + short_number(*value, 4));
    if (report.tangled_cells.value_or(0) > 0)
        parts.push_back(std::to_string(*report.tangled_cells) +
                        (*report.tangled_cells == 1 ? " tangled cell" : " tangled cells"));
    if (!earlier && report.status != RunStatus::running && report.status != RunStatus::preparing)
        parts.emplace_back(status_name(report.status));
    return parts;
}

} // namespace gaspard
