#include "gui/panels/status_bar.hpp"

#include "core/session/report_columns.hpp"
#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <imgui.h>
#include <optional>
#include <vector>

namespace gaspard {

namespace {

/// The newest report with diagnostics; null before the first.
const StepReport* last_measured(const std::vector<StepReport>& history) {
    for (auto report = history.rbegin(); report != history.rend(); ++report)
        if (report->measured()) return &*report;
    return nullptr;
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
    case RunStatus::interrupted:
        return {"State", "Interrupted", Tone::warning};
    case RunStatus::failed:
        return {"State", "Failed", Tone::bad};
    }
    return {};
}

std::vector<StatusCell> status_cells(const DocumentRun& run) {
    const StepReport* now = run.history.empty() ? nullptr : &run.history.back();
    const StepReport* measured = last_measured(run.history);
    const auto rate = iteration_rate(run.history);
    const std::string none = "-";
    std::vector<StatusCell> cells{describe_state(run.status, run.wants_to_run)};
    cells.push_back({"Iteration", now ? std::to_string(now->iteration) : none});
    for (const char* name : {"residual", "equidistribution", "min_jacobian"}) {
        const SeriesTrace& series = *run.curves.find(name);
        const std::vector<double>& values = series.trace.values; // of the iterates that have one
        const auto value = series.info.measured
                               ? (values.empty() ? std::nullopt : std::optional(values.back()))
                           : now ? now->value(name)
                                 : std::nullopt;
        cells.push_back({series.info.label, value ? short_number(*value) : none});
        const SeriesInfo* criterion = now ? other_criterion(*now) : nullptr;
        if (series.info.name != "residual" || !criterion) continue;
        const auto end = now->value(criterion->name);
        cells.push_back({criterion->label, end ? short_number(*end) : none});
    }
    const auto tangled = measured ? measured->tangled_cells : std::nullopt;
    const auto drawn = measured ? measured->value("folded_drawn_cells") : std::nullopt;
    std::string count = tangled ? std::to_string(*tangled) : none;
    if (drawn && *drawn > static_cast<double>(tangled.value_or(0)))
        count += " (" + short_number(*drawn) + " drawn fold)";
    cells.push_back({"Tangled cells", count, tangled && *tangled > 0 ? Tone::bad : Tone::plain});
    cells.push_back({"Iterations / s", rate ? short_number(*rate) : none});
    return cells;
}

std::string method_note(const DocumentRun& run, const Catalogue& catalogue) {
    for (std::size_t i = run.history.size(); i-- > 1;) {
        const StepReport& report = run.history[i];
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

void draw_status_bar(const DocumentRun& run, const Notice& message, const StatusTexts& texts,
                     const Theme& theme, ItemRectangles& items) {
    const auto cells = status_cells(run);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float em = ImGui::GetFontSize(), line = 1.35F * em;
    const float pitch =
        std::min(10.5F * em, ImGui::GetContentRegionAvail().x / static_cast<float>(cells.size()));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const ImVec2 at(start.x + pitch * static_cast<float>(i), start.y);
        list.AddText(at, ImGui::GetColorU32(ImGuiCol_TextDisabled), cells[i].label.c_str());
        list.AddText({at.x, at.y + line}, ImGui::GetColorU32(tone_colour(theme, cells[i].tone)),
                     cells[i].value.c_str());
        items["status." + std::to_string(i)] = {at.x, at.y, at.x + pitch, at.y + 2 * line};
    }
    ImGui::SetCursorScreenPos({start.x, start.y + 2 * line + 0.3F * em});
    if (!message.text.empty()) {
        ImGui::TextColored(tone_colour(theme, message.error ? Tone::bad : Tone::good), "%s",
                           message.text.c_str());
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", message.text.c_str()); // a narrow window clips the text
    } else if (!texts.closing.empty()) {
        ImGui::TextColored(tone_colour(theme, Tone::warning), "%s", texts.closing.c_str());
    } else if (texts.method.empty()) {
        ImGui::TextDisabled("%s", texts.hint.c_str());
    } else {
        ImGui::TextUnformatted(texts.method.c_str());
        ImGui::SameLine(0, 2 * em);
        const bool fits = ImGui::CalcTextSize(texts.hint.c_str()).x <= ImGui::GetContentRegionAvail().x;
        ImGui::TextDisabled("%s", fits ? texts.hint.c_str() : "");
    }
    remember_item(items, "message");
    ItemRectangle& shown = items["message"];
    shown.right = std::min(shown.right, ImGui::GetWindowPos().x + ImGui::GetWindowWidth());
}

} // namespace gaspard
