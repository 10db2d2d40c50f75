#include "gui/document/runs_csv.hpp"

#include "core/base/csv.hpp"
#include "core/session/report_columns.hpp"

#include <array>

namespace gaspard {

std::string runs_csv(const DocumentRuns& runs) {
    static constexpr std::array<std::string_view, 8> always = {
        "iteration",    "seconds",      "residual",  "equidistribution",
        "min_jacobian", "max_jacobian", "step_size", "tangled_cells"};
    std::vector<std::string> columns(always.begin(), always.end());
    for (const DocumentRun& run : runs)
        if (!run.hidden) add_columns(columns, run.history);
    std::string text = "run," + csv_head(columns) + '\n';
    for (const DocumentRun& run : runs) {
        if (run.hidden) continue;
        const std::string name = csv_text(run.name);
        for (const StepReport& row : run.history) text += name + ',' + csv_row(row, columns) + '\n';
    }
    return text;
}

} // namespace gaspard
