#include "gui/panels/plot_pane.hpp"

#include "core/session/time_series.hpp"
#include "gui/base/part_window.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/plot/plot_widget.hpp"

#include <algorithm>
#include <iterator>

namespace gaspard {

namespace {

constexpr const char* menu_id = "##menu";

/// The width of a button or of a list without an arrow.
float width_of(std::string_view label) {
    return ImGui::CalcTextSize(label.data(), label.data() + label.size()).x +
           2 * ImGui::GetStyle().FramePadding.x;
}

struct Entry {
    std::string_view name, label;
    std::string help{};
};

/// The place of the entry that was clicked.
std::optional<std::size_t> draw_list(const std::string& key, std::span<const Entry> entries,
                                     std::string_view chosen, std::string_view label, float width,
                                     ItemRectangles& items) {
    ImGui::SetNextItemWidth(width);
    const std::string shown = shortened(std::string(label), width - 2 * ImGui::GetStyle().FramePadding.x);
    const bool open = ImGui::BeginCombo(("##" + key).c_str(), shown.c_str(),
                                        ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLargest);
    remember_item(items, key);
    if (!open) return std::nullopt;
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& one = entries[i];
        if (ImGui::Selectable(std::string(one.label).c_str(), one.name == chosen)) clicked = i;
        remember_item(items, key + "=" + std::string(one.name));
        if (!one.help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", one.help.c_str());
    }
    ImGui::EndCombo();
    return clicked;
}

/// "θ: the constant that ..."
std::string help_of(const RunPlot& plot) {
    return (plot.info->symbol.empty() ? "" : plot.info->symbol + ": ") + plot.info->help;
}

void draw_plots_list(const std::string& key, const DocumentRuns& runs, PlotChoice& choice, float width,
                     ItemRectangles& items) {
    const std::vector<RunPlot> plots = plots_of(runs);
    std::vector<Entry> entries;
    for (const RunPlot& plot : plots) entries.push_back({plot.name, plot.label, help_of(plot)});
    const auto clicked = draw_list(key, entries, choice.plot, plot_label(runs, choice.plot), width, items);
    for (const Entry& one : entries)
        if (one.name == choice.plot && !clicked && ImGui::IsItemHovered() && !one.help.empty())
            ImGui::SetTooltip("%s", one.help.c_str());
    if (!clicked || plots[*clicked].name == choice.plot) return;
    choice = with_plot(runs, choice, plots[*clicked]);
}

void draw_abscissa_list(const std::string& key, const DocumentRuns& runs, PlotChoice& choice, float width,
                        ItemRectangles& items) {
    const std::vector<Abscissa> all = abscissas_of(runs, choice.plot);
    std::vector<Entry> entries;
    std::vector<std::string> labels;
    for (const Abscissa& one : all) labels.push_back(label_of(runs, one));
    for (std::size_t i = 0; i < all.size(); ++i) entries.push_back({all[i], labels[i]});
    const auto clicked =
        draw_list(key, entries, choice.abscissa, label_of(runs, choice.abscissa), width, items);
    if (clicked) choice = with_abscissa(runs, choice, all[*clicked]);
}

/// A button that stays pressed.
void draw_toggle(const char* label, bool& on, const char* help, const Theme& theme) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(on ? theme.accent : theme.faint_text));
    if (ImGui::Button(label)) on = !on;
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
}

/// A new axis shows its whole range.
void forget_zoom(const PlotChoice& before, const PlotChoice& now, PlotZoom& zoom) {
    if (before.plot != now.plot || before.log_y != now.log_y) zoom.y.reset();
    if (before.abscissa != now.abscissa || before.log_x != now.log_x) zoom.x.reset();
}

} // namespace

void PlotPane::choose(std::size_t plot, const PlotChoice& choice) {
    forget_zoom(plots_[plot].choice, choice, plots_[plot].zoom);
    plots_[plot].choice = choice;
}

void PlotPane::draw_header(const std::string& name, const Document& document, Shown& plot,
                           const FrameContext& context) {
    const float gap = ImGui::GetStyle().ItemSpacing.x / 2, available = ImGui::GetContentRegionAvail().x;
    const float log = width_of("log"), menu = width_of("..."), against = width_of("iterations");
    // Where there is not enough space for all, the list of plots comes first; the menu has the rest too.
    const bool with_abscissa = available >= width_of("Equidistr.") + against + log + menu + 3 * gap;
    const bool with_log = with_abscissa || available >= width_of("Equidistr.") + log + menu + 2 * gap;
    float rest = available - menu - gap;
    if (with_log) rest -= log + gap;
    if (with_abscissa) rest -= against + gap;
    draw_plots_list(name + ".quantity", document.runs(), plot.choice,
                    std::min(std::max(rest, 1.0F), width_of("Equidistribution")), context.items);
    if (with_abscissa) {
        ImGui::SameLine(0, gap);
        draw_abscissa_list(name + ".abscissa", document.runs(), plot.choice, against, context.items);
    }
    if (with_log) {
        ImGui::SameLine(0, gap);
        draw_toggle("log", plot.choice.log_y, "Logarithmic vertical axis", context.theme);
        remember_item(context.items, name + ".log");
    }
    ImGui::SameLine(0, gap);
    if (ImGui::Button("...")) ImGui::OpenPopup(menu_id);
    remember_item(context.items, name + ".menu");
}

std::optional<PlotWish> PlotPane::draw_menu(const std::string& name, const Document& document, Shown& plot,
                                            const FrameContext& context) {
    if (!ImGui::BeginPopup(menu_id)) return std::nullopt;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
    std::optional<PlotWish> wish;
    const auto entry = [&](const char* label, const std::string& key, bool checked = false,
                           bool possible = true) {
        const bool pressed = ImGui::MenuItem(label, nullptr, checked, possible);
        remember_item(context.items, name + ".menu." + key);
        return pressed;
    };
    const auto offer = [&](const char* label, const char* key, PlotWish::Kind kind) {
        if (entry(label, key)) wish = PlotWish{kind, plot.choice, plot.zoom, &plot == &plots_[0] ? 0U : 1U};
    };
    offer("Copy as CSV", "csv", PlotWish::Kind::copy_csv);
    offer("Save as PNG", "png", PlotWish::Kind::save_png);
    offer("Save as SVG", "svg", PlotWish::Kind::save_svg);
    ImGui::Separator();
    if (entry("Show everything", "everything", false, plot.zoom != PlotZoom{})) plot.zoom = {};
    ImGui::Separator();
    PlotChoice& choice = plot.choice;
    for (const Abscissa& one : abscissas_of(document.runs(), choice.plot)) {
        const std::string label = "Against " + label_of(document.runs(), one);
        if (entry(label.c_str(), one, choice.abscissa == one))
            choice = with_abscissa(document.runs(), choice, one);
    }
    if (entry("Logarithmic x", "log-x", choice.log_x)) choice.log_x = !choice.log_x;
    if (entry("Logarithmic y", "log-y", choice.log_y)) choice.log_y = !choice.log_y;
    ImGui::Separator();
    if (entry("Solves before the last change", "earlier", earlier_)) earlier_ = !earlier_;
    ImGui::EndPopup();
    return wish;
}

/// Where a row of a history lies along a plot.
static double abscissa_of(const StepReport& row, const Abscissa& abscissa) {
    return abscissa == "iterations" ? row.iteration
           : abscissa == "time"     ? time_of(row).value_or(0)
                                    : row.seconds;
}

/// The iteration at which a run's history has reached this place along a plot.
static double iteration_at(const std::vector<StepReport>& history, const Abscissa& abscissa, double place) {
    const auto after =
        std::lower_bound(history.begin(), history.end(), place,
                         [&](const StepReport& row, double at) { return abscissa_of(row, abscissa) < at; });
    if (after == history.begin() || history.empty()) return 0;
    if (after == history.end()) return history.back().iteration;
    const StepReport &before = *std::prev(after), &next = *after;
    const double from = abscissa_of(before, abscissa);
    const double way = (place - from) / std::max(abscissa_of(next, abscissa) - from, 1e-300);
    return before.iteration + way * (next.iteration - before.iteration);
}

bool PlotPane::draw_curves(const Document& document, Shown& plot, const Plot& study,
                           const FrameContext& context, const DocumentRun& longest,
                           const StepReport* cursor) {
    const bool of_study = is_made_elsewhere(plot.choice.plot);
    PlotView view = of_study ? view_of(study) : view_of_runs(document.runs(), plot.choice, earlier_);
    const Abscissa abscissa = plot.choice.abscissa == "time" && !has_time_steps(document.runs())
                                  ? Abscissa("iterations")
                                  : plot.choice.abscissa;
    if (cursor && !of_study)
        view.marks.push_back(
            {.x = abscissa_of(*cursor, abscissa), .label = "the iterate that is shown", .handle = true});
    const bool sweeps =
        plot.choice.plot == error_study_plot && plot.choice.abscissa != "cells" && !study.curves.empty();
    PlotPointing pointing{sweeps ? PlotPointing::Use::sweep : PlotPointing::Use::point};
    const bool menu = plot_widget("##curves", view, ImGui::GetContentRegionAvail(), plot.zoom, context.theme,
                                  context.scale, sweeps || !of_study ? &pointing : nullptr);
    double_clicked_ = double_clicked_ || pointing.double_clicked;
    if (!pointing.x) return menu;
    if (sweeps)
        sweep_ = PlotSweep{plot.choice.abscissa, *pointing.x};
    else
        pointed_ =
            abscissa == "iterations" ? *pointing.x : iteration_at(longest.history, abscissa, *pointing.x);
    return menu;
}

/// A run that begins to move in time is plotted against the time, and a plot that no run has is another one.
void PlotPane::suit(const Document& document) {
    const bool reported =
        std::ranges::any_of(document.runs(), [](const auto& run) { return !run.history.empty(); });
    const std::vector<RunPlot> plots = plots_of(document.runs());
    constexpr std::array<std::string_view, 2> usual{"residual", "equidistribution"};
    for (std::size_t i = 0; i < plots_.size() && reported; ++i) {
        const auto is_named = [](std::string_view name) {
            return [name](const RunPlot& plot) { return plot.name == name; };
        };
        if (std::ranges::any_of(plots, is_named(plots_[i].choice.plot))) continue;
        const auto other = std::ranges::find_if(plots, is_named(usual[i]));
        if (other != plots.end()) choose(i, with_plot(document.runs(), plots_[i].choice, *other));
    }
    const bool moves = has_time_steps(document.runs());
    if (!moves) fits_time_ = false;
    if (!std::exchange(moved_, moves) && moves)
        for (Shown& plot : plots_)
            if (plot.choice.abscissa == "iterations") {
                const PlotChoice before = plot.choice;
                plot.choice = with_abscissa(document.runs(), before, "time");
                forget_zoom(before, plot.choice, plot.zoom);
            }
    if (!moves)
        for (Shown& plot : plots_)
            if (plot.choice.abscissa == "time") plot.choice.abscissa = "iterations";
    if (moves && !fits_time_) suit_time(document.runs());
}

/// Once there are some time steps, a plot with nothing to show becomes another one: where each is solved by a
/// formula, the distance to the result is 0, which no logarithmic axis has.
void PlotPane::suit_time(const DocumentRuns& runs) {
    constexpr std::ptrdiff_t some = 3;
    const auto many = [](const DocumentRun& run) {
        return std::ranges::count_if(run.history, is_time_step) >= some;
    };
    if (std::ranges::none_of(runs, many)) return;
    fits_time_ = true;
    for (std::size_t i = 0; i < plots_.size(); ++i) {
        const PlotChoice& choice = plots_[i].choice;
        if (is_made_elsewhere(choice.plot) || !is_blank(runs, choice)) continue;
        for (const RunPlot& plot : plots_of(runs)) {
            const bool usual = plot.name == "equidistribution" || plot.name == "mesh-speed";
            const PlotChoice other = with_plot(runs, choice, plot);
            if (!usual || plots_[1 - i].choice.plot == plot.name || is_blank(runs, other)) continue;
            choose(i, other);
            break;
        }
    }
}

std::optional<PlotWish> PlotPane::frame(const Document& document, const ItemRectangle& first,
                                        const ItemRectangle& second, const FrameContext& context,
                                        const DocumentRun& longest, const std::array<Plot, 2>& studies,
                                        const StepReport* cursor) {
    std::optional<PlotWish> wish;
    sweep_.reset();
    pointed_.reset();
    suit(document);
    const auto draw = [&](const std::string& name, const ItemRectangle& part, Shown& plot,
                          const Plot& study) {
        if (!(part.width() > 0)) return; // there is no space for it
        begin_part(name.c_str(), part);
        context.items[name] = part;
        const PlotChoice before = plot.choice;
        draw_header(name, document, plot, context);
        forget_zoom(before, plot.choice, plot.zoom);
        const bool menu = draw_curves(document, plot, study, context, longest, cursor);
        remember_item(context.items, name + ".curves");
        if (menu) ImGui::OpenPopup(menu_id);
        const PlotChoice unturned = plot.choice;
        if (auto wanted = draw_menu(name, document, plot, context)) wish = std::move(wanted);
        forget_zoom(unturned, plot.choice, plot.zoom);
        ImGui::End();
    };
    draw("plot.first", first, plots_[0], studies[0]);
    draw("plot.second", second, plots_[1], studies[1]);
    return wish;
}

} // namespace gaspard
