// The interpolation errors of a run: when they are measured, and what reports and snapshots have of them.
#include "core/monitor/solution.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/session/run.hpp"

#include <cmath>
#include <utility>

namespace gaspard {

bool Run::interpolates(const Course& course) {
    return course.problem.scenario.method.values.boolean("interpolation") &&
           diagnostics(course) == Diagnostics::full &&
           !course.discretisation->target_outline(); // the uniform mesh lies in another domain
}

std::shared_ptr<const ScalarFunction> Run::solution() const { return solution_of(now_.data); }

std::shared_ptr<const InterpolationComparison> Run::interpolation(InterpolationOptions options) {
    if (!interpolates(now_)) return nullptr;
    refresh();
    options.threads = threads_;
    const auto mesh = now_.discretisation->mesh();
    Interpolated next = interpolated_;
    if (next.mesh != mesh || next.monitor != now_.data.monitor || next.tolerance > options.tolerance)
        next = {.mesh = mesh, .monitor = now_.data.monitor, .tolerance = options.tolerance};
    const auto measure = [&, u = solution()](const Points& x) {
        return std::make_shared<const InterpolationError>(
            interpolation_error(*mesh, x, space(), *u, options));
    };
    if (!next.uniform) next.uniform = measure(mesh->nodes);
    if (!next.last || next.last->version != version_) {
        const Points& x = now_.method->positions();
        next.last = std::make_shared<const InterpolationComparison>(
            InterpolationComparison{.uniform = next.uniform,
                                    .adapted = x == mesh->nodes ? next.uniform : measure(x),
                                    .version = version_});
    }
    interpolated_ = std::move(next);
    const std::vector<SeriesInfo> series = interpolation_series();
    const SeriesValues values = values_of(*interpolated_.last);
    for (std::size_t i = 0; i < series.size(); ++i) history_.back().set(series[i].name, values[i]);
    return interpolated_.last;
}

/// As last measured: while values change, that may be of an earlier monitor.
void Run::add_interpolation(Snapshot& snapshot) const {
    if (!interpolates(now_) || interpolated_.mesh != snapshot.mesh || !interpolated_.last) return;
    snapshot.interpolation = interpolated_.last;
    const InterpolationComparison& errors = *snapshot.interpolation;
    if (errors.exact() || !std::isfinite(errors.adapted->of(ErrorNorm::l2))) return; // nothing to see
    const auto add = [&](const char* name, std::vector<double> values) -> Field& {
        return snapshot.fields.emplace_back(Field{mesh_colour(name), std::move(values)});
    };
    const auto range = errors.range(ErrorNorm::l2);
    add("interpolation_error", errors.adapted->of_cells(ErrorNorm::l2)).range = range;
    add("interpolation_error_uniform", errors.uniform->of_cells(ErrorNorm::l2)).range = range;
    add("interpolation_ratio", errors.cell_ratios(ErrorNorm::l2));
}

} // namespace gaspard
