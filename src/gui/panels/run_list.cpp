#include "gui/panels/run_list.hpp"

#include "gui/base/icons.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>
#include <optional>

namespace gaspard {

namespace {

/// A line in the run's colour, as in the plots.
void draw_swatch(const DocumentRun& run, const Theme& theme) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float thickness = (run.live() ? 0.28F : 0.16F) * em, middle = at.y + height / 2;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x, middle - thickness / 2}, {at.x + em, middle + thickness / 2},
        packed(curve_colour(theme, run.colour), run.hidden ? 0.35F : 1.0F), thickness / 2);
    ImGui::Dummy({em, height});
}

/// An open eye, or one crossed out.
bool draw_eye(const char* id, const DocumentRun& run, const Theme& theme) {
    const bool pressed =
        eye_button(id, run.hidden, packed(run.hidden ? theme.faint_text : theme.text), packed(theme.accent));
    if (ImGui::IsItemHovered()) {
        const std::string why =
            run.set_aside ? "Hidden, as it solves another problem: " + run.title + ".\n" : "";
        ImGui::SetTooltip("%s", (why + (run.hidden ? "Show in the plots" : "Hide in the plots")).c_str());
    }
    return pressed;
}

bool draw_cross(const char* id, const Theme& theme) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight(), half = 0.24F * em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(id, {1.3F * em, height});
    const ImVec2 middle{at.x + 0.65F * em, at.y + height / 2};
    const ImU32 colour = packed(ImGui::IsItemHovered() ? theme.bad : theme.faint_text);
    const float thickness = std::max(1.0F, 0.1F * em);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}, colour, thickness);
    list.AddLine({middle.x - half, middle.y + half}, {middle.x + half, middle.y - half}, colour, thickness);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Remove this run");
    return pressed;
}

/// As much of the text as fits, in whole letters of UTF-8.
template <std::size_t size>
std::array<char, size> buffer_of(const std::string& text) {
    std::size_t length = std::min(text.size(), size - 1);
    while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xc0U) == 0x80U)
        --length;
    std::array<char, size> buffer{};
    std::copy_n(text.begin(), length, buffer.begin());
    return buffer;
}

} // namespace

void RunList::draw_name(Document& document, const DocumentRun& run, const std::string& key, float width,
                        const FrameContext& context) {
    if (run.live()) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(shortened(run.name + " (now)", width).c_str());
        remember_item(context.items, key);
        return;
    }
    auto text = buffer_of<200>(run.name);
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, packed(context.theme.frame, 0.4F));
    const bool edited = ImGui::InputText(("##" + key).c_str(), text.data(), text.size());
    ImGui::PopStyleColor();
    remember_item(context.items, key);
    if (ImGui::IsItemActivated()) name_before_ = run.name;
    if (edited) document.rename(run.id, text.data());
    if (ImGui::IsItemDeactivated() && run.name.find_first_not_of(' ') == std::string::npos)
        document.rename(run.id, name_before_); // every run has a name
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) ImGui::SetTooltip("%s", run.name.c_str());
}

bool RunList::draw(Document& document, const Action& keep, const FrameContext& context) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, em = ImGui::GetFontSize();
    std::optional<RunId> removed;
    std::size_t place = 0;
    for (const DocumentRun& run : document.runs()) {
        const std::string key = "runs." + std::to_string(place++);
        const bool removable = !run.live() && run.id != document.active().id;
        ImGui::PushID(static_cast<int>(run.id));
        draw_swatch(run, context.theme);
        ImGui::SameLine(0, gap);
        if (draw_eye("##eye", run, context.theme)) document.hide(run.id, !run.hidden);
        remember_item(context.items, key + ".eye");
        ImGui::SameLine(0, gap);
        const float available = ImGui::GetContentRegionAvail().x - (removable ? 1.3F * em + gap : 0);
        draw_name(document, run, key + ".name", std::max(available, 1.0F), context);
        if (removable) {
            ImGui::SameLine(0, gap);
            if (draw_cross("##remove", context.theme)) removed = run.id;
            remember_item(context.items, key + ".remove");
        }
        ImGui::PopID();
    }
    if (removed) document.remove(*removed);
    const bool wanted = ImGui::Button((std::string(keep.label) + " this run").c_str());
    remember_item(context.items, "runs.keep");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip_of(keep).c_str());
    return wanted;
}

} // namespace gaspard
