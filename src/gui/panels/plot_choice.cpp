#include "gui/panels/plot_choice.hpp"

#include "core/base/check.hpp"
#include "core/base/join.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/line_section.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/document/value_changes.hpp"
#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace gaspard {

namespace {

constexpr std::string_view axis_name(bool logarithmic) { return logarithmic ? "log" : "linear"; }

/// Which series there are depends on the methods.
bool is_plot_name(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return c == '-' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    });
}

bool of_runs(const Abscissa& abscissa) {
    return abscissa == "iterations" || abscissa == "seconds" || abscissa == "time";
}

/// Which an error study can have depends on the problem.
bool is_abscissa(std::string_view plot, const Abscissa& name) {
    if (plot == section_plot) return name == along_section;
    if (plot != error_study_plot) return of_runs(name);
    if (name == along_section) return false;
    return !name.empty() && !of_runs(name) && std::none_of(name.begin(), name.end(), [](char c) {
        return c == ' ' || c == '"' || static_cast<unsigned char>(c) < ' ';
    });
}

std::optional<bool> logarithmic_of(std::string_view name) {
    if (name != axis_name(true) && name != axis_name(false)) return std::nullopt;
    return name == axis_name(true);
}

CurveView view_of(const SeriesTrace& series, const Abscissa& abscissa) {
    const Trace& trace = series.trace;
    CurveView view{.label = {},
                   .part = series.info.plot ? series.info.plot->part : std::string_view(),
                   .x = abscissa == "seconds" ? trace.seconds : trace.iterations,
                   .y = trace.values,
                   .extremes = &trace.extremes};
    if (abscissa == "time")
        view.x = trace.times, view.y = trace.values_in_time, view.extremes = &trace.extremes_in_time;
    return view;
}

/// Time only where there is some.
Abscissa abscissa_for(const DocumentRuns& runs, const PlotChoice& choice) {
    return choice.abscissa == "time" && !has_time_steps(runs) ? Abscissa("iterations") : choice.abscissa;
}

/// The newest at the strength of `most`.
void add_earlier(const DocumentRun& run, std::string_view plot, const Abscissa& abscissa, PlotView& view) {
    constexpr float most = 0.5F, fading = 0.72F;
    float opacity = most;
    for (auto solve = run.earlier.rbegin(); solve != run.earlier.rend(); ++solve, opacity *= fading)
        for (const SeriesTrace& series : solve->curves.all()) {
            if (series.plot != plot) continue;
            CurveView curve = view_of(series, abscissa);
            curve.colour = run.colour, curve.name = solve->name;
            curve.behind = true, curve.opacity = opacity;
            view.curves.push_back(std::move(curve));
        }
}

/// "θ", "‖r‖ / ‖θ‖ [m]", "Inner iterations"
std::string name_of_values(const SeriesInfo& info) {
    const std::string& label = info.plot ? info.plot->label : info.label;
    return (info.symbol.empty() ? label : info.symbol) + (info.unit.empty() ? "" : " [" + info.unit + "]");
}

/// Where the plot has the series by which the run is judged.
void add_tolerance(const DocumentRun& run, const PlotChoice& choice, PlotView& view) {
    if (run.history.empty()) return;
    const auto tolerance = tolerance_of(run.scenario, run.history.back());
    if (!tolerance) return;
    const SeriesTable& table = *run.history.back().series;
    if (plot_name(table.all()[table.criterion()]) != choice.plot) return;
    for (const LevelView& level : view.levels)
        if (level.y == *tolerance) return;
    view.levels.push_back({*tolerance, "tolerance " + short_number(*tolerance)});
}

PlotView make_view(const DocumentRuns& runs, const PlotChoice& choice, bool in_window, bool earlier) {
    const Abscissa abscissa = abscissa_for(runs, choice);
    PlotView view;
    view.x = {.label = abscissa == "iterations" ? "iteration"
                       : abscissa == "time"     ? "time t"
                                                : "seconds",
              .logarithmic = choice.log_x,
              .whole = abscissa == "iterations"};
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
            view.y.label = name_of_values(series.info);
            CurveView curve = view_of(series, abscissa);
            curve.label = label;
            curve.colour = run.colour;
            curve.behind = !run.live();
            view.curves.push_back(std::move(curve));
        }
        add_tolerance(run, choice, view);
    }
    for (const DocumentRun& run : runs)
        if (earlier && !run.hidden) add_earlier(run, choice.plot, abscissa, view);
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

/// The run whose values an error study varies; null if there is none.
const DocumentRun* studied_run(const DocumentRuns& runs) {
    for (const DocumentRun& run : runs)
        if (run.live() && !study_variables(run.scenario).empty()) return &run;
    return nullptr;
}

const SeriesInfo& error_study_info() {
    static const SeriesInfo info{.name = std::string(error_study_plot),
                                 .label = "Error study",
                                 .scale = ParameterScale::logarithmic,
                                 .help = "the energy error of runs with other numbers of cells, other ε or "
                                         "other numbers of the monitor, which are solved in the background"};
    return info;
}

const SeriesInfo& section_info() {
    static const SeriesInfo info{.name = std::string(section_plot),
                                 .label = "Section line",
                                 .help = "the values of the colours along a line, whose ends can be dragged "
                                         "on the mesh (view.section)"};
    return info;
}

} // namespace

std::vector<RunPlot> plots_of(const DocumentRuns& runs) {
    std::vector<RunPlot> plots;
    if (studied_run(runs)) plots.push_back({error_study_plot, error_study_info().label, &error_study_info()});
    for (const DocumentRun& run : runs)
        for (const auto& [info, name, trace] : run.curves.all()) {
            const bool known = std::any_of(plots.begin(), plots.end(),
                                           [&](const RunPlot& plot) { return plot.name == name; });
            if (known) continue;
            const std::string_view label = info.plot ? info.plot->label : info.label;
            plots.push_back({name, label, &info});
        }
    for (const DocumentRun& run : runs)
        if (run.snapshot && has_section_line(*run.snapshot->mesh)) {
            plots.push_back({section_plot, section_info().label, &section_info()});
            break;
        }
    return plots;
}

std::string_view plot_label(const DocumentRuns& runs, std::string_view name) {
    for (const RunPlot& plot : plots_of(runs))
        if (plot.name == name) return plot.label;
    return name;
}

bool is_blank(const DocumentRuns& runs, const PlotChoice& choice) {
    if (!choice.log_y) return false;
    const PlotView view = make_view(runs, choice, false, false);
    bool blank = false;
    for (const CurveView& curve : view.curves)
        for (const double y : curve.y) {
            if (y > 0) return false;
            blank = blank || y <= 0; // not where it was not measured
        }
    return blank;
}

bool has_time_steps(const DocumentRuns& runs) {
    return std::any_of(runs.begin(), runs.end(), [](const DocumentRun& run) {
        return !run.hidden && !run.history.empty() && is_time_step(run.history.back());
    });
}

std::vector<Abscissa> abscissas_of(const DocumentRuns& runs, std::string_view plot) {
    if (plot == section_plot) return {std::string(along_section)};
    if (plot != error_study_plot)
        return has_time_steps(runs) ? std::vector<Abscissa>{"iterations", "seconds", "time"}
                                    : std::vector<Abscissa>{"iterations", "seconds"};
    const DocumentRun* run = studied_run(runs);
    return run ? study_variables(run->scenario) : std::vector<Abscissa>{};
}

PlotChoice with_plot(const DocumentRuns& runs, const PlotChoice& choice, const RunPlot& plot) {
    PlotChoice changed = choice;
    changed.plot = plot.name;
    changed.log_y = plot.info->scale == ParameterScale::logarithmic;
    if (is_abscissa(plot.name, choice.abscissa)) return changed;
    return with_abscissa(runs, changed,
                         plot.name == error_study_plot ? "cells"
                         : plot.name == section_plot   ? Abscissa(along_section)
                                                       : "iterations");
}

PlotChoice with_abscissa(const DocumentRuns& runs, const PlotChoice& choice, const Abscissa& abscissa) {
    PlotChoice changed = choice;
    const DocumentRun* run = studied_run(runs);
    if (abscissa == along_section)
        changed.log_x = false;
    else if (!of_runs(abscissa))
        changed.log_x = run && has_factors(run->scenario, study_key(run->scenario, abscissa));
    else if (!of_runs(choice.abscissa))
        changed.log_x = false;
    changed.abscissa = abscissa;
    return changed;
}

std::string label_of(const DocumentRuns& runs, const Abscissa& abscissa) {
    if (abscissa == along_section) return "length";
    const DocumentRun* run = of_runs(abscissa) ? nullptr : studied_run(runs);
    return run ? study_label(run->scenario, abscissa) : abscissa;
}

std::string format_choice(const PlotChoice& choice) {
    std::string text = choice.plot;
    for (const std::string_view word :
         {std::string_view(choice.abscissa), axis_name(choice.log_x), axis_name(choice.log_y)})
        text.append(",").append(word);
    return text;
}

std::optional<PlotChoice> parse_choice(std::string_view text) {
    const auto words = split(text, ",");
    if (words.size() != 4) return std::nullopt;
    const Abscissa abscissa(words[1]);
    const auto log_x = logarithmic_of(words[2]), log_y = logarithmic_of(words[3]);
    if (!is_plot_name(words[0]) || !is_abscissa(words[0], abscissa) || !log_x || !log_y) return std::nullopt;
    return PlotChoice{std::string(words[0]), abscissa, *log_x, *log_y};
}

PlotView view_of_runs(const DocumentRuns& runs, const PlotChoice& choice, bool earlier) {
    // Only among others does it matter which one still moves.
    return make_view(runs, choice, runs.size() > 1, earlier);
}

Plot plot_of_runs(const DocumentRuns& runs, const PlotChoice& choice, const PlotZoom& zoom) {
    const PlotView view = make_view(runs, choice, false, false); // a file does not mark the current iterate
    Plot plot{.title = std::string(plot_label(runs, choice.plot)), .x = view.x, .y = view.y, .curves = {}};
    for (const CurveView& curve : view.curves) {
        plot.curves.push_back(thinned(curve, view, zoom));
        if (curve.part != view.curves.front().part)
            plot.curves.back().label.clear(); // one entry in the legend per run
    }
    for (const LevelView& level : view.levels) plot.levels.push_back({level.y, level.label});
    return zoomed(std::move(plot), zoom);
}

Plot zoomed(Plot plot, const PlotZoom& zoom) {
    ask_for(plot.x, zoom.x);
    ask_for(plot.y, zoom.y);
    return plot;
}

} // namespace gaspard
