#include "gui/panels/playback_bar.hpp"

#include "core/base/join.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/document/value_changes.hpp"
#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>
#include <string>

namespace gaspard {

namespace {

/// A square button with an icon; `width` in heights. True when pressed.
bool draw_button(const Action& row, Icon icon, float width, bool main, const FrameContext& context) {
    const float height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos(), size{width * height, height};
    const bool lit = row.is_checked();
    ImGui::BeginDisabled(!row.is_enabled());
    ImGui::PushStyleColor(ImGuiCol_Button, main ? to_imgui(context.theme.accent) : ImVec4(0, 0, 0, 0));
    if (main)
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive));
    const bool pressed = ImGui::Button(("##" + std::string(row.name)).c_str(), size);
    ImGui::PopStyleColor(main ? 2 : 1);
    const Colour colour = main ? context.theme.background : lit ? context.theme.accent : context.theme.text;
    draw_icon(*ImGui::GetWindowDrawList(), icon, {at.x + size.x / 2, at.y + size.y / 2}, 0.46F * height,
              packed(opaque(colour), row.is_enabled() ? 1.0F : 0.35F));
    ImGui::EndDisabled();
    remember_item(context.items, "action." + std::string(row.name));
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%s", row.is_enabled() || row.why_disabled().empty()
                                    ? (row.current_label() + "\n" + tooltip_of(row)).c_str()
                                    : row.why_disabled().c_str());
    return pressed;
}

/// Where the iterations lie along the track.
struct Track {
    float left = 0, right = 0, middle = 0;
    int last = 0;

    float at(double iteration) const {
        return last > 0 ? left + (right - left) * static_cast<float>(iteration / last) : right;
    }
    double under(float x) const {
        if (!(right > left)) return 0;
        return last * static_cast<double>(std::clamp((x - left) / (right - left), 0.0F, 1.0F));
    }
};

/// The iterations of one run whose meshes have tangled cells.
struct Tangles {
    const DocumentRun* run;
    std::string name; ///< "Newton: "; empty if there is only one run
    std::vector<std::pair<int, int>> ranges;
    std::vector<std::pair<int, int>> places; ///< the same along the track

    std::string text() const { return name + tangled_text(ranges, last_iteration(*run)); }
};

std::vector<const DocumentRun*> shown_runs(const PlaybackRuns& runs) {
    std::vector<const DocumentRun*> all = runs.beside;
    if (all.empty() || !runs.active->hidden) all.insert(all.begin(), runs.active);
    return all;
}

/// Where an iteration of a run is along the track, which is that of the longest.
int place_of(const DocumentRun& longest, const DocumentRun& run, int iteration) {
    return iteration_beside(run, longest, iteration);
}

std::vector<Tangles> tangles_of(const std::vector<const DocumentRun*>& shown, const DocumentRun& longest) {
    std::vector<std::string> names;
    for (const DocumentRun* run : shown) names.push_back(run->name);
    names = what_differs(names);
    std::vector<Tangles> found;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        auto ranges = tangled_ranges(shown[i]->history), places = ranges;
        if (ranges.empty()) continue;
        for (auto& [first, last] : places)
            first = place_of(longest, *shown[i], first), last = place_of(longest, *shown[i], last);
        found.push_back(
            {shown[i], shown.size() > 1 ? names[i] + ": " : "", std::move(ranges), std::move(places)});
    }
    return found;
}

/// Below the track, from the first of them on where there is enough space.
void draw_tangled_text(const Track& track, const std::vector<Tangles>& tangles, float top,
                       const Theme& theme) {
    constexpr float small = 0.82F;
    std::vector<std::string> texts;
    int first = track.last;
    for (const Tangles& one : tangles) {
        texts.push_back(one.text());
        first = std::min(first, one.places.front().first);
    }
    const std::string text = shortened(join(texts, "; "), (track.right - track.left) / small);
    const float width = small * text_size(text).x;
    ImGui::GetWindowDrawList()->AddText(
        ImGui::GetFont(), small * ImGui::GetFontSize(),
        {std::clamp(track.at(first), track.left, std::max(track.left, track.right - width)), top},
        packed(theme.tangled), text.c_str());
}

/// A lane of marks for each run; among others each mark begins with the run's colour.
void draw_tangles(const Track& track, const std::vector<Tangles>& tangles, bool several,
                  const FrameContext& context) {
    if (tangles.empty()) return;
    const float half = 6 * context.scale, least = std::max(2.0F, 2 * context.scale);
    const float lane = 2 * half / static_cast<float>(tangles.size());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float top = track.middle - half;
    for (std::size_t i = 0; i < tangles.size(); ++i, top += lane) {
        const float bottom = top + std::max(lane - context.scale, 1.0F);
        for (const auto& [first, last] : tangles[i].places) {
            const float left = track.at(first), right = std::max(track.at(last), left + least);
            list.AddRectFilled({left, top}, {right, bottom}, packed(context.theme.tangled));
            if (several)
                list.AddRectFilled({left - 2 * least, top}, {left, bottom},
                                   packed(curve_colour(context.theme, tangles[i].run->colour)));
        }
        const auto [first, last] = tangles[i].places.front();
        context.items["playback.tangled." + std::to_string(i)] = {track.at(first), top, track.at(last),
                                                                  bottom};
    }
    draw_tangled_text(track, tangles, track.middle + 8.5F * context.scale, context.theme);
}

void draw_track(const Track& track, double position, const std::vector<const DocumentRun*>& shown,
                const DocumentRun& longest, bool lit, const FrameContext& context) {
    const Theme& theme = context.theme;
    const float half = 2.5F * context.scale, knob = (lit ? 8.5F : 7.5F) * context.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float here = track.at(position);
    list.AddRectFilled({track.left, track.middle - half}, {track.right, track.middle + half},
                       packed(theme.frame), half);
    list.AddRectFilled({track.left, track.middle - half}, {here, track.middle + half}, packed(theme.accent),
                       half);
    for (const DocumentRun* run : shown) // where shorter ones end
        if (const int last = place_of(longest, *run, last_iteration(*run)); last < track.last)
            list.AddRectFilled({track.at(last) - context.scale, track.middle - 2 * half},
                               {track.at(last) + context.scale, track.middle + 2 * half},
                               packed(curve_colour(theme, run->colour)));
    draw_tangles(track, tangles_of(shown, longest), shown.size() > 1, context);
    list.AddCircleFilled({here, track.middle}, knob, packed(theme.text), 32);
}

/// What is at an iteration of the longest run: "Iteration 12" or "Time 0.3", and of several runs which are
/// tangled there or have ended before.
std::string text_at(int iteration, const std::vector<const DocumentRun*>& shown, const DocumentRun& longest) {
    std::string text = "Iteration " + std::to_string(iteration);
    const auto row = std::ranges::lower_bound(longest.history, iteration, {}, &StepReport::iteration);
    if (row != longest.history.end() && is_time_step(*row))
        text = "Time " + short_number(*time_at(longest, iteration), 5);
    for (const Tangles& one : tangles_of(shown, longest))
        for (const auto& [first, last] : one.places)
            if (first <= iteration && iteration <= last) {
                text += "\n" + one.text();
                break;
            }
    for (const DocumentRun* run : shown) {
        const int last = last_iteration(*run);
        if (place_of(longest, *run, last) >= iteration) continue;
        const auto time = run->history.empty() ? std::nullopt : time_of(run->history.back());
        text += "\n" + run->name + ": ended at " +
                (time ? "t = " + short_number(*time, 5) : std::to_string(last));
    }
    return text;
}

void draw_scrubber(const PlaybackRuns& runs, Playback& playback, float width, const FrameContext& context) {
    const float height = ImGui::GetFrameHeight(), knob = 9 * context.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const DocumentRun& run = *runs.longest;
    const bool possible = run.recording && run.history.size() > 1;
    Track track{corner.x + knob, corner.x + width - knob, corner.y + height / 2, last_iteration(run)};
    ImGui::InvisibleButton("##scrubber", {width, height});
    remember_item(context.items, "playback.scrubber");
    const bool hovered = ImGui::IsItemHovered();
    const double under = track.under(ImGui::GetIO().MousePos.x);
    if (possible && ImGui::IsItemActive()) playback.go_to(run, under);
    if (possible && hovered && ImGui::GetIO().MouseWheel != 0)
        ImGui::GetIO().MouseWheel > 0 ? playback.go_back(run) : playback.go_forward(run);
    const std::vector<const DocumentRun*> shown = shown_runs(runs);
    if (possible && hovered && !ImGui::IsItemActive())
        ImGui::SetTooltip("%s", text_at(static_cast<int>(std::lround(under)), shown, run).c_str());
    draw_track(track, playback.iteration(run), shown, run, hovered || ImGui::IsItemActive(), context);
}

void draw_rates(Playback& playback, float width, const FrameContext& context) {
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo("##rate", rate_text(playback.rate()).c_str());
    remember_item(context.items, "playback.rate");
    if (!open) {
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Iterations per second of the replay");
        return;
    }
    for (const double rate : Playback::rates) {
        const std::string text = rate > 0 ? rate_text(rate) : "as fast as it is drawn";
        if (ImGui::Selectable(text.c_str(), rate == playback.rate())) playback.set_rate(rate);
        remember_item(context.items, "playback.rate=" + rate_text(rate));
    }
    ImGui::EndCombo();
}

/// "14 / 27", as wide whatever the first number is.
void draw_position(const DocumentRun& run, const Playback& playback, std::size_t recorded,
                   const FrameContext& context) {
    const int last = last_iteration(run);
    const std::string widest = std::to_string(last) + " / " + std::to_string(last);
    const std::string text = std::to_string(playback.iteration(run)) + " / " + std::to_string(last);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float full = ImGui::CalcTextSize(widest.c_str()).x;
    const Colour colour = playback.live() ? context.theme.faint_text : context.theme.text;
    write_text(*ImGui::GetWindowDrawList(),
               {at.x + full - ImGui::CalcTextSize(text.c_str()).x, at.y + ImGui::GetStyle().FramePadding.y},
               colour, text);
    ImGui::Dummy({full, ImGui::GetFrameHeight()});
    remember_item(context.items, "playback.position");
    if (run.recording && ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", recording_text(run, recorded).c_str());
}

/// What a narrow bar has no space for. The name of an action that was chosen.
std::optional<std::string_view> draw_more(Playback& playback, std::span<const std::string_view> names,
                                          std::span<const Action> actions, const FrameContext& context) {
    std::optional<std::string_view> pressed;
    if (ImGui::Button("...", {1.15F * ImGui::GetFrameHeight(), 0})) ImGui::OpenPopup("##more");
    remember_item(context.items, "playback.more");
    if (!ImGui::BeginPopup("##more")) return pressed;
    for (const std::string_view name : names) {
        const Action& row = find_action(actions, name);
        if (ImGui::MenuItem(row.current_label().c_str(), describe_keys(row).c_str(), row.is_checked(),
                            row.is_enabled()))
            pressed = row.name;
        remember_item(context.items, "action." + std::string(name));
    }
    draw_rates(playback, 7 * ImGui::GetFontSize(), context);
    ImGui::EndPopup();
    return pressed;
}

} // namespace

std::optional<std::string_view> draw_playback_bar(const PlaybackRuns& runs, Playback& playback,
                                                  std::span<const Action> actions,
                                                  const FrameContext& context) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight(), gap = 0.2F * em;
    const bool moves = playback.playing() || (runs.active->solving() && playback.live());
    std::optional<std::string_view> pressed;
    const auto button = [&](std::string_view name, Icon icon, float width = 1.15F, bool main = false) {
        const Action& row = find_action(actions, name);
        if (draw_button(row, icon, width, main, context)) pressed = row.name;
        ImGui::SameLine(0, gap);
    };
    const float available = ImGui::GetContentRegionAvail().x;
    const bool wide = available > 35 * em, medium = available > 26 * em, narrow = available < 20 * em;
    button("reset", Icon::reset);
    if (medium) button("to-start", Icon::to_start);
    if (!narrow) button("step-back", Icon::back);
    button("run", moves ? Icon::pause : Icon::run, 1.9F, true);
    if (!narrow) button("step", Icon::step);
    if (medium) button("to-end", Icon::to_end);
    ImGui::SameLine(0, 0.8F * em);
    const int last = last_iteration(*runs.longest);
    const float numbers =
        ImGui::CalcTextSize((std::to_string(last) + " / " + std::to_string(last)).c_str()).x;
    const float rates = 5.6F * em, square = 1.15F * height, toggles = 3 * (square + gap);
    float rest = ImGui::GetContentRegionAvail().x - numbers - 0.8F * em;
    rest -= wide ? rates + toggles + 2 * 0.8F * em : square + 0.8F * em;
    draw_scrubber(runs, playback, std::max(3 * em, rest), context);
    ImGui::SameLine(0, 0.8F * em);
    draw_position(*runs.longest, playback, runs.recorded, context);
    ImGui::SameLine(0, 0.8F * em);
    if (!wide) {
        constexpr std::array<std::string_view, 7> more{"step-back", "step",       "to-start",   "to-end",
                                                       "loop",      "blend-loop", "record-film"};
        const std::size_t first = medium ? 4 : narrow ? 0 : 2;
        const auto chosen = draw_more(playback, std::span(more).subspan(first), actions, context);
        return chosen ? chosen : pressed;
    }
    draw_rates(playback, rates, context);
    ImGui::SameLine(0, 0.8F * em);
    button("loop", Icon::loop);
    button("blend-loop", Icon::blend);
    button("record-film", Icon::film);
    return pressed;
}

std::string recording_text(const DocumentRun& run, std::size_t all) {
    constexpr std::size_t megabyte = std::size_t{1} << 20U;
    const auto whole = [](std::size_t bytes) { return std::to_string(bytes / megabyte); };
    std::string text;
    if (run.recording) {
        // The recording is ahead of the history while the solver runs.
        const std::size_t kept = run.recording->iterations().size();
        const int first = run.history.empty() ? 0 : run.history.front().iteration;
        const auto made = static_cast<std::size_t>(std::max(0, last_iteration(run) - first) + 1);
        const int stride = run.recording->stride();
        text =
            "Recorded: " + std::to_string(kept) + " of " + std::to_string(std::max(kept, made)) + " iterates";
        if (stride > 1) text += ", one of every " + std::to_string(stride);
        text += "\n";
    }
    return text + (all < megabyte ? "less than 1" : whole(all)) + " of " + whole(recording_memory) +
           " MB for all runs";
}

std::string tangled_text(const std::vector<std::pair<int, int>>& ranges, int last) {
    if (ranges.empty()) return {};
    const auto [from, to] = ranges.front();
    std::string text = "tangled ";
    if (to == last && from < to)
        text += "from " + std::to_string(from);
    else
        text += std::to_string(from) + (from < to ? "–" + std::to_string(to) : std::string());
    return ranges.size() > 1 ? text + ", ..." : text;
}

std::string rate_text(double rate) { return rate > 0 ? short_number(rate) + " / s" : "max"; }

} // namespace gaspard
