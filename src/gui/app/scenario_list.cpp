#include "gui/app/scenario_list.hpp"

#include "core/scenario/toml.hpp"
#include "gui/base/plot_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

namespace {

/// The prefix of a name and its group, in the order of the list.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> groups{{{"plane", "Plane"},
                                                                               {"walls", "Plane"},
                                                                               {"flow", "Plane"},
                                                                               {"sphere", "Sphere"},
                                                                               {"spline", "Splines"},
                                                                               {"transport", "Transport"},
                                                                               {"layer", "Layers"}}};

std::size_t place_of(std::string_view name) {
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (name.starts_with(groups[i].first)) return i;
    return groups.size();
}

/// For a search: without capitals, and without dots on letters.
std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const auto& [letter, plain] : {std::pair{"ö", "o"}, {"ä", "a"}, {"ü", "u"}})
        for (std::size_t at = 0; (at = text.find(letter)) != std::string::npos;) text.replace(at, 2, plain);
    return text;
}

bool matches(const Scenario& one, const std::string& search) {
    const std::string all = lower(one.name + " " + one.title + " " + one.description);
    return all.find(lower(search)) != std::string::npos;
}

} // namespace

std::string_view scenario_group(std::string_view name) {
    const std::size_t place = place_of(name);
    return place < groups.size() ? groups[place].second : "Others";
}

std::string short_description(const std::string& description) {
    const std::size_t source = description.find(" (");
    std::string text = description.substr(0, source);
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text;
}

std::optional<ScenarioChoice> ScenarioList::draw_rows(const DocumentRun& run, const FrameContext& context) {
    const float em = ImGui::GetFontSize(), column = 15 * em, whole = 46 * em;
    std::optional<ScenarioChoice> chosen;
    std::string_view group;
    for (const Scenario& one : shipped_) {
        if (!matches(one, search_)) continue;
        if (scenario_group(one.name) != group) {
            group = scenario_group(one.name);
            ImGui::Spacing();
            ImGui::TextColored(to_imgui(context.theme.accent), "%s", std::string(group).c_str());
        }
        const bool current = run.scenario.name == one.name && run.scenario.modified.empty();
        if (ImGui::Selectable(("##" + one.name).c_str(), current, 0, {whole, 0})) chosen = {false, one.name};
        remember_item(context.items, "scenario=" + one.name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", one.name.c_str(), one.description.c_str());
        ImGui::SameLine(em);
        ImGui::TextUnformatted(shortened(one.title, column - em).c_str());
        ImGui::SameLine(em + column);
        ImGui::TextDisabled("%s",
                            shortened(short_description(one.description), whole - column - 2 * em).c_str());
    }
    if (group.empty()) ImGui::TextDisabled("No scenario matches.");
    return chosen;
}

std::optional<ScenarioChoice> ScenarioList::draw(const Catalogue& catalogue, const DocumentRun& run,
                                                 const std::vector<std::string>& recent, float width,
                                                 const FrameContext& context) {
    ImGui::SetNextItemWidth(width);
    const float em = ImGui::GetFontSize(), high = ImGui::GetIO().DisplaySize.y - 4 * em;
    ImGui::SetNextWindowSizeConstraints({std::min(48 * em, ImGui::GetIO().DisplaySize.x), 0},
                                        {FLT_MAX, high});
    const bool open = ImGui::BeginCombo("##scenario", run.title.c_str(), ImGuiComboFlags_HeightLargest);
    remember_item(context.items, "scenario");
    if (!open) return {};
    if (shipped_.empty()) {
        for (const BuiltinScenario& one : builtin_scenarios())
            shipped_.push_back(find_scenario(catalogue, std::string(one.name)));
        std::stable_sort(shipped_.begin(), shipped_.end(), [](const Scenario& a, const Scenario& b) {
            return place_of(a.name) < place_of(b.name);
        });
    }
    if (ImGui::IsWindowAppearing()) search_.clear(), ImGui::SetKeyboardFocusHere();
    ImGui::Spacing();
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::InputTextWithHint("##search", "Search", &search_);
    remember_item(context.items, "scenario.search");
    std::optional<ScenarioChoice> chosen = draw_rows(run, context);
    if (!recent.empty()) ImGui::Separator();
    for (const std::string& file : recent)
        if (ImGui::Selectable(file.c_str())) chosen = {true, file};
    if (chosen) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
    return chosen;
}

} // namespace gaspard
