#include "gui/document/runs_csv.hpp"

namespace gaspard {

namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char letter : text) result += letter == '"' ? "\"\"" : std::string(1, letter);
    return result + "\"";
}

} // namespace

std::string runs_csv(const DocumentRuns& runs) {
    std::string text =
        "run,iteration,seconds,residual,equidistribution,min_jacobian,max_jacobian,step_size,tangled_cells\n";
    for (const DocumentRun& run : runs) {
        if (run.hidden) continue;
        const std::string name = quoted(run.name);
        for (const StepReport& row : run.history) {
            text += name + ',' + std::to_string(row.iteration) + ',' + format_number(row.seconds) + ',' +
                    format_number(row.residual) + ',' + format_number(row.equidistribution) + ',' +
                    format_number(row.min_jacobian) + ',' + format_number(row.max_jacobian) + ',' +
                    format_number(row.step_size) + ',';
            text += row.tangled_cells ? std::to_string(*row.tangled_cells) : "";
            text += '\n';
        }
    }
    return text;
}

} // namespace gaspard
