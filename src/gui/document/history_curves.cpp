#include "gui/document/history_curves.hpp"

#include "core/session/time_series.hpp"

#include <algorithm>

namespace gaspard {

void Trace::append(const StepReport& report, double value) {
    iterations.push_back(report.iteration);
    seconds.push_back(report.seconds);
    values.push_back(value);
    extremes.append(value);
    if (!is_time_step(report)) return;
    times.push_back(*time_of(report));
    values_in_time.push_back(value);
    extremes_in_time.append(value);
}

void HistoryCurves::follow(const std::shared_ptr<const SeriesTable>& table) {
    table_ = table;
    of_place_.clear();
    for (const SeriesInfo& info : table->all()) {
        const auto found = std::find_if(traces_.begin(), traces_.end(),
                                        [&](const SeriesTrace& one) { return one.info.name == info.name; });
        of_place_.push_back(static_cast<std::size_t>(found - traces_.begin()));
        if (found == traces_.end())
            traces_.push_back({info, plot_name(info), {}});
        else
            found->info = info; // another method may mean something else by it
    }
}

void HistoryCurves::append(const StepReport& report) {
    if (table_ != report.series) follow(report.series);
    for (std::size_t place = 0; place < of_place_.size(); ++place)
        if (const auto value = report.value(place)) traces_[of_place_[place]].trace.append(report, *value);
}

void HistoryCurves::complete(const StepReport& last, const StepReport& completed) {
    if (table_ != completed.series) follow(completed.series);
    for (std::size_t place = 0; place < of_place_.size(); ++place)
        if (const auto value = completed.value(place); value && !last.value(place))
            traces_[of_place_[place]].trace.append(completed, *value);
}

const SeriesTrace* HistoryCurves::find(std::string_view name) const {
    for (const SeriesTrace& one : traces_)
        if (one.info.name == name) return &one;
    return nullptr;
}

std::string plot_name(const SeriesInfo& info) {
    std::string name = info.plot ? info.plot->name : info.name;
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

} // namespace gaspard
