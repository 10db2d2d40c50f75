#include "gui/panels/status_bar.hpp"

#include "core/session/report_columns.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <imgui.h>
#include <optional>
#include <span>
#include <vector>

namespace gaspard {

namespace {

/// The newest report with diagnostics in these rows; null before the first.
const StepReport* last_measured(std::span<const StepReport> history) {
    for (auto report = history.rbegin(); report != history.rend(); ++report)
        if (report->measured()) return &*report;
    return nullptr;
}

/// The rows of a history up to an iteration.
std::span<const StepReport> up_to(const std::vector<StepReport>& history, int iteration) {
    const auto after = std::upper_bound(history.begin(), history.end(), iteration,
                                        [](int at, const StepReport& row) { return at < row.iteration; });
    return {history.begin(), after};
}

/// The last value up to an iteration.
std::optional<double> last_value_up_to(const Trace& trace, int iteration) {
    const auto after = std::upper_bound(trace.iterations.begin(), trace.iterations.end(), iteration);
    if (after == trace.iterations.begin()) return std::nullopt;
    return trace.values[static_cast<std::size_t>(after - trace.iterations.begin()) - 1];
}

std::string help_of(const SeriesInfo& info) {
    return (info.symbol.empty() ? "" : info.symbol + ": ") + info.help;
}

} // namespace

ImVec4 tone_colour(const Theme& theme, Tone tone) {
    switch (tone) {
    case Tone::plain:
        break;
    case Tone::good:
        return to_imgui(theme.good);
    case Tone::busy:
        return to_imgui(theme.accent);
    case Tone::warning:
        return to_imgui(theme.warning);
    case Tone::bad:
        return to_imgui(theme.bad);
    }
    return to_imgui(theme.text);
}

StatusCell describe_state(const SolverStatus& status, bool wants_to_run) {
    if (status.activity.starts_with("writing")) return {"State", "Writing", Tone::busy};
    if (!status.activity.empty()) return {"State", "Preparing", Tone::busy};
    switch (status.run) {
    case RunStatus::preparing:
        return {"State", "Preparing", Tone::busy};
    case RunStatus::running:
        return wants_to_run ? StatusCell{"State", "Running", Tone::busy}
                            : StatusCell{"State", "Paused", Tone::warning};
    case RunStatus::converged:
        return {"State", "Converged", Tone::good};
    case RunStatus::iteration_limit:
        return {"State", "Iteration limit", Tone::warning};
    case RunStatus::stalled:
        return {"State", "Stalled", Tone::warning};
    case RunStatus::diverged:
        return {"State", "Diverged", Tone::bad};
    case RunStatus::tangled:
        return {"State", "Tangled", Tone::bad};
    case RunStatus::invalid_input:
        return {"State", "Invalid input", Tone::bad};
    case RunStatus::interrupted:
        return {"State", "Interrupted", Tone::warning};
    case RunStatus::failed:
        return {"State", "Failed", Tone::bad};
    }
    return {};
}

std::vector<StatusCell> status_cells(const DocumentRun& run, int iteration) {
    const std::span<const StepReport> rows = up_to(run.history, iteration);
    const StepReport* now = rows.empty() ? nullptr : &rows.back();
    const StepReport* measured = last_measured(rows);
    const auto rate = iteration_rate(run.history);
    const std::string none = "-";
    std::vector<StatusCell> cells{describe_state(run.status, run.wants_to_run)};
    if (const auto time = now ? time_of(*now) : std::nullopt)
        cells.push_back({"Time t", short_number(*time, 5), Tone::plain, "of the monitor, which moves"});
    if (now && is_time_step(*now))
        cells.push_back({"Iterations of the step", short_number(*now->value(time_names::iterations)),
                         Tone::plain, "of this time step"});
    else
        cells.push_back({"Iteration", now ? std::to_string(now->iteration) : none});
    for (const char* name : {"residual", "equidistribution", "min_jacobian"}) {
        const SeriesTrace& series = *run.curves.find(name);
        const auto value = series.info.measured ? last_value_up_to(series.trace, iteration)
                           : now                ? now->value(name)
                                                : std::nullopt;
        cells.push_back(
            {series.info.label, value ? short_number(*value) : none, Tone::plain, help_of(series.info)});
        const SeriesInfo* criterion = now ? other_criterion(*now) : nullptr;
        if (series.info.name != "residual" || !criterion) continue;
        const auto end = now->value(criterion->name);
        cells.push_back(
            {criterion->label, end ? short_number(*end) : none, Tone::plain, help_of(*criterion)});
    }
    const auto tangled = measured ? measured->tangled_cells : std::nullopt;
    const auto drawn = measured ? measured->value("folded_drawn_cells") : std::nullopt;
    std::string count = tangled ? std::to_string(*tangled) : none;
    if (drawn && *drawn > static_cast<double>(tangled.value_or(0)))
        count += " (" + short_number(*drawn) + " drawn fold)";
    cells.push_back({"Tangled cells", count, tangled && *tangled > 0 ? Tone::bad : Tone::plain,
                     "cells in which the mesh folds over itself: det dx/dξ is not positive everywhere"});
    cells.push_back(
        {now && is_time_step(*now) ? "Steps / s" : "Iterations / s", rate ? short_number(*rate) : none});
    return cells;
}

std::string method_note(const DocumentRun& run, const Catalogue& catalogue, int iteration) {
    const std::span<const StepReport> rows = up_to(run.history, iteration);
    for (std::size_t i = rows.size(); i-- > 1;) {
        const StepReport& report = rows[i];
        if (is_time_step(rows.back()) && !is_time_step(report)) break; // of the solve for the start
        if (report.note.empty()) continue;
        return catalogue.method(run.scenario.method.type).label + ", from iteration " +
               std::to_string(report.iteration) + ": " + report.note;
    }
    return {};
}

std::string closing_note(const DocumentRun& run, const Action& reset) {
    if (run.history.empty() || !run.ended() || run.status.run == RunStatus::converged) return {};
    std::string note = run.history.back().note;
    if (note.empty()) return {};
    note.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(note.front())));
    const bool failed = run.status.run == RunStatus::diverged || run.status.run == RunStatus::tangled;
    if (failed) note += "; " + describe_keys(reset) + " starts from the beginning";
    return note + ".";
}

bool has_linear_cells(const DocumentRun& run) {
    return run.live() && find_remedy(run.scenario.domain.values).has_value();
}

std::string remedy_note(const DocumentRun& run) {
    const StepReport* measured = last_measured(run.history);
    const bool tangled = measured && measured->tangled_cells.value_or(0) > 0;
    const bool failed = run.status.run == RunStatus::diverged || run.status.run == RunStatus::tangled;
    if (!has_linear_cells(run) || !(failed || tangled)) return {};
    return failed
               ? "Linear cells cannot follow this monitor on the sphere. Quadratic cells are curved and can."
               : "Linear cells are tangling. Quadratic cells are curved and can follow this monitor.";
}

void draw_status_bar(const std::vector<StatusCell>& cells, const std::string& note, const std::string& hint,
                     const FrameContext& context) {
    const Theme& theme = context.theme;
    const ImVec2 window = ImGui::GetWindowPos();
    const float em = ImGui::GetFontSize(), gap = 0.4F * em, right = window.x + ImGui::GetWindowWidth() - em;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto write = [&](ImVec2 at, const ImVec4& colour, const std::string& text) {
        list.AddText(at, ImGui::GetColorU32(colour), text.c_str());
        return ImGui::CalcTextSize(text.c_str()).x;
    };
    const auto note_cell = [&](std::size_t i, ImVec2 from, float to) {
        const ItemRectangle place{from.x, from.y, to, from.y + em};
        context.items["status." + std::to_string(i)] = place;
        const bool hovered = ImGui::IsMouseHoveringRect({place.left, place.top}, {place.right, place.bottom});
        if (hovered && !cells[i].help.empty() && ImGui::IsWindowHovered())
            ImGui::SetTooltip("%s", cells[i].help.c_str());
    };
    const ImVec2 first{window.x + em, window.y + 0.85F * em};
    note_cell(0, first, first.x + write(first, tone_colour(theme, cells[0].tone), cells[0].value));
    float at = first.x;
    const float row = window.y + 2.95F * em;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        const float width = ImGui::CalcTextSize((cells[i].label + cells[i].value).c_str()).x + gap;
        if (at + width > right) break; // the last ones matter least
        const ImVec2 from{at, row};
        at += write({at, row}, to_imgui(theme.faint_text), cells[i].label) + gap;
        at += write({at, row}, tone_colour(theme, cells[i].tone), cells[i].value);
        note_cell(i, from, at);
        at += 1.4F * em;
    }
    for (const std::string& text : {note + (note.empty() || hint.empty() ? "" : "   ") + hint, note, hint}) {
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        if (text.empty() || at + width > right) continue;
        write({right - width, row}, to_imgui(theme.faint_text), text);
        context.items["hint"] = {right - width, row, right, row + em};
        break;
    }
}

} // namespace gaspard
