#include "gui/document/history_curves.hpp"

namespace gaspard {

void Trace::append(const StepReport& report, double value) {
    iterations.push_back(report.iteration);
    seconds.push_back(report.seconds);
    values.push_back(value);
    extremes.append(value);
}

void HistoryCurves::append(const StepReport& report) {
    residual.append(report, report.residual);
    if (report.equidistribution) equidistribution.append(report, *report.equidistribution);
    if (report.min_jacobian) min_jacobian.append(report, *report.min_jacobian);
    if (report.max_jacobian) max_jacobian.append(report, *report.max_jacobian);
    if (report.step_size > 0) step_size.append(report, report.step_size);
}

} // namespace gaspard
