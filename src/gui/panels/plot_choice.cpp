#include "gui/panels/plot_choice.hpp"

#include "core/base/check.hpp"
#include "core/base/join.hpp"
#include "gui/document/value_changes.hpp"
#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gaspard {

namespace {

constexpr std::string_view axis_name(bool logarithmic) { return logarithmic ? "log" : "linear"; }

std::optional<Abscissa> abscissa_of(std::string_view name) {
    for (const Abscissa one : abscissas())
        if (name_of(one) == name) return one;
    return std::nullopt;
}

/// Which series there are depends on the methods.
bool is_plot_name(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return c == '-' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    });
}

std::optional<bool> logarithmic_of(std::string_view name) {
    if (name != axis_name(true) && name != axis_name(false)) return std::nullopt;
    return name == axis_name(true);
}

PlotView make_view(const DocumentRuns& runs, const PlotChoice& choice, bool in_window) {
    const bool by_iteration = choice.abscissa == Abscissa::iterations;
    PlotView view;
    view.x = {by_iteration ? "iteration" : "seconds", choice.log_x};
    view.y = {"", choice.log_y};
    std::vector<std::string> names;
    for (const DocumentRun& run : runs)
        if (!run.hidden) names.push_back(run.name);
    if (in_window) names = what_differs(names);
    std::size_t shown = 0;
    for (const DocumentRun& run : runs) {
        if (run.hidden) continue;
        const std::string name = names[shown++], label = run.live() && in_window ? name + " (now)" : name;
        for (const SeriesTrace& series : run.curves.all()) {
            if (series.plot != choice.plot) continue;
            const Trace& trace = series.trace;
            view.y.label = series.info.unit;
            view.curves.push_back({.label = label,
                                   .part = series.info.plot ? series.info.plot->part : std::string_view(),
                                   .x = by_iteration ? trace.iterations : trace.seconds,
                                   .y = trace.values,
                                   .extremes = &trace.extremes,
                                   .colour = run.colour,
                                   .behind = !run.live()});
        }
        for (const ChangeMark& mark : run.marks)
            view.marks.push_back({by_iteration ? mark.iteration : mark.seconds, mark.text, run.colour});
    }
    return view;
}

/// As many points of a curve as an image `columns` pixels wide can show.
Curve thinned(const CurveView& view, const PlotView& plot, const PlotZoom& zoom) {
    constexpr float columns = 2000;
    Curve curve{.label = view.label, .x = {}, .y = {}, .colour = view.colour};
    if (!view.extremes || static_cast<float>(view.x.size()) <= 2 * columns) {
        curve.x.assign(view.x.begin(), view.x.end());
        curve.y.assign(view.y.begin(), view.y.end());
        return curve;
    }
    PlotFrame frame;
    frame.x = plot.x, frame.y = plot.y;
    frame.x_range = zoom.x ? *zoom.x : home_range(plot, false);
    frame.y_range = zoom.y ? *zoom.y : home_range(plot, true);
    frame.area = {{0, 0}, {columns, columns}};
    const PixelPath path = pixel_path(view, frame);
    for (std::size_t i = 0; i < path.x.size(); ++i) {
        const bool gap = std::isnan(path.y[i]);
        curve.x.push_back(from_axis(plot.x, frame.position_x(path.x[i])));
        curve.y.push_back(gap ? path.y[i] : from_axis(plot.y, frame.position_y(path.y[i])));
    }
    return curve;
}

void ask_for(Axis& axis, const std::optional<AxisRange>& range) {
    if (!range) return;
    axis.low = from_axis(axis, range->low);
    axis.high = from_axis(axis, range->high);
}

} // namespace

std::vector<RunPlot> plots_of(const DocumentRuns& runs) {
    std::vector<RunPlot> plots;
    for (const DocumentRun& run : runs)
        for (const auto& [info, name, trace] : run.curves.all()) {
            const bool known = std::any_of(plots.begin(), plots.end(),
                                           [&](const RunPlot& plot) { return plot.name == name; });
            if (known) continue;
            const std::string_view label = info.plot ? info.plot->label : info.label;
            plots.push_back({name, label, &info});
        }
    return plots;
}

std::string_view plot_label(const DocumentRuns& runs, std::string_view name) {
    for (const RunPlot& plot : plots_of(runs))
        if (plot.name == name) return plot.label;
    return name;
}

std::span<const Abscissa> abscissas() {
    static constexpr std::array all = {Abscissa::iterations, Abscissa::seconds};
    return all;
}

std::string_view name_of(Abscissa abscissa) {
    return abscissa == Abscissa::iterations ? "iterations" : "seconds";
}
std::string_view label_of(Abscissa abscissa) { return name_of(abscissa); }

std::string format_choice(const PlotChoice& choice) {
    std::string text = choice.plot;
    for (const std::string_view word :
         {name_of(choice.abscissa), axis_name(choice.log_x), axis_name(choice.log_y)})
        text.append(",").append(word);
    return text;
}

std::optional<PlotChoice> parse_choice(std::string_view text) {
    const auto words = split(text, ",");
    if (words.size() != 4) return std::nullopt;
    const auto abscissa = abscissa_of(words[1]);
    const auto log_x = logarithmic_of(words[2]), log_y = logarithmic_of(words[3]);
    if (!is_plot_name(words[0]) || !abscissa || !log_x || !log_y) return std::nullopt;
    return PlotChoice{std::string(words[0]), *abscissa, *log_x, *log_y};
}

PlotView view_of_runs(const DocumentRuns& runs, const PlotChoice& choice) {
    return make_view(runs, choice, runs.size() > 1); // only among others does it matter which one still moves
}

Plot plot_of_runs(const DocumentRuns& runs, const PlotChoice& choice, const PlotZoom& zoom) {
    const PlotView view = make_view(runs, choice, false); // a file does not mark the current iterate
    Plot plot{.title = std::string(plot_label(runs, choice.plot)), .x = view.x, .y = view.y, .curves = {}};
    ask_for(plot.x, zoom.x);
    ask_for(plot.y, zoom.y);
    for (const CurveView& curve : view.curves) {
        plot.curves.push_back(thinned(curve, view, zoom));
        if (curve.part != view.curves.front().part)
            plot.curves.back().label.clear(); // one entry in the legend per run
    }
    for (const MarkView& mark : view.marks) plot.marks.push_back({mark.x, std::string(mark.label)});
    return plot;
}

} // namespace gaspard
