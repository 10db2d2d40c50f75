#include "gui/app/scenario_list.hpp"

#include "core/scenario/toml.hpp"
#include "gui/base/plot_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

namespace {

/// The prefix of a name and its group, in the order of the list.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> groups{{{"plane", "Plane"},
                                                                               {"walls", "Plane"},
                                                                               {"front", "Plane"},
                                                                               {"flow", "Plane"},
                                                                               {"sphere", "Sphere"},
                                                                               {"spline", "Splines"},
                                                                               {"transport", "Transport"},
                                                                               {"layer", "Layers"},
                                                                               {"burgers", "Layers"}}};

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

namespace {

// Sizes at scale 1.
constexpr float card_pad = 7, card_gap = 4;

ImVec2 card_size(float scale) {
    return {(static_cast<float>(thumbnail_width) + 2 * card_pad) * scale,
            (static_cast<float>(thumbnail_height) + 3 * card_pad) * scale + 2 * ImGui::GetFontSize()};
}

/// So many cards beside each other.
int columns_within(float width, float scale) {
    const float step = card_size(scale).x + card_gap * scale;
    return std::clamp(static_cast<int>(width / step), 2, 7);
}

/// In at most two lines, the second one shortened.
void draw_title(ImDrawList& list, ImVec2 at, float width, const std::string& title, const Theme& theme) {
    ImFont* font = ImGui::GetFont();
    const float size = ImGui::GetFontSize();
    const char* end = title.c_str() + title.size();
    const char* wrap = font->CalcWordWrapPositionA(size / font->FontSize, title.c_str(), end, width);
    const std::string first(title.c_str(), wrap);
    while (wrap < end && *wrap == ' ') ++wrap;
    const auto line = [&](float y, const std::string& text) {
        const float centred = std::max(0.0F, (width - text_size(text).x) / 2);
        write_text(list, {at.x + centred, y}, theme.text, text);
    };
    line(at.y, shortened(first, width));
    if (wrap < end) line(at.y + size, shortened(std::string_view(wrap, end), width));
}

/// A mesh in grey, where there is no picture.
void draw_no_picture(ImDrawList& list, ImVec2 low, ImVec2 high, const Theme& theme, float scale) {
    list.AddRectFilled(low, high, packed(theme.frame), 3 * scale);
    constexpr int lines = 6;
    const float step = (high.y - low.y) / (lines + 2), half = step * lines / 2;
    const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    const ImU32 ink = packed(theme.faint_text, 0.5F);
    for (int i = 0; i <= lines; ++i) { // closer in the middle
        const float t = static_cast<float>(i) / lines * 2 - 1, away = half * t * (0.5F + 0.5F * t * t);
        list.AddLine({middle.x + away, middle.y - half}, {middle.x + away, middle.y + half}, ink, scale);
        list.AddLine({middle.x - half, middle.y + away}, {middle.x + half, middle.y + away}, ink, scale);
    }
}

/// A key that is held repeats, but not because a frame was slow.
bool key_pressed(ImGuiKey key) {
    const bool fluent = ImGui::GetIO().DeltaTime < 0.1F;
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), fluent);
}

} // namespace

/// The cards that match what is typed, by group: built-in scenarios, then files.
std::vector<ScenarioList::Card> ScenarioList::cards(const std::vector<std::string>& recent) const {
    std::vector<Card> cards;
    for (const Scenario& one : shipped_)
        if (matches(one, search_))
            cards.push_back({{false, one.name},
                             std::string(scenario_group(one.name)),
                             one.title,
                             short_description(one.description) + "."});
    for (const std::string& file : recent)
        if (lower(file).find(lower(search_)) != std::string::npos)
            cards.push_back(
                {{true, file}, "Opened before", std::filesystem::path(file).filename().string(), file});
    return cards;
}

/// Arrow keys move the mark from card to card; up and down to the nearest column of the next row.
void ScenarioList::move_mark(const std::vector<Card>& cards, int columns) {
    if (cards.empty()) return;
    std::vector<std::pair<int, int>> places; // row and column of each card
    int row = 0, column = 0;
    for (std::size_t i = 0; i < cards.size(); ++i) {
        if (i > 0 && (++column == columns || cards[i].group != cards[i - 1].group)) ++row, column = 0;
        places.emplace_back(row, column);
    }
    const int last = static_cast<int>(cards.size()) - 1;
    const int before = marked_;
    const auto to_row = [&](int by) {
        const auto [r, c] = places[static_cast<std::size_t>(std::max(marked_, 0))];
        for (int i = 0, best = columns; i <= last; ++i) {
            const auto [row_of, column_of] = places[static_cast<std::size_t>(i)];
            if (row_of == r + by && std::abs(column_of - c) < best)
                best = std::abs(column_of - c), marked_ = i;
        }
    };
    const bool none = marked_ < 0;
    if (key_pressed(ImGuiKey_DownArrow)) none ? void(marked_ = 0) : to_row(1);
    if (key_pressed(ImGuiKey_UpArrow) && !none) to_row(-1);
    if (key_pressed(ImGuiKey_RightArrow)) marked_ = std::min(marked_ + 1, last);
    if (key_pressed(ImGuiKey_LeftArrow) && !none) marked_ = std::max(marked_ - 1, 0);
    marked_ = std::min(marked_, last);
    scroll_to_mark_ = marked_ != before;
}

/// The scenario that is open has a bar at its left; the card that Enter would open has a frame.
static void mark_card(ImDrawList& list, ImVec2 low, ImVec2 high, bool lit, bool current, const Theme& theme,
                      float scale) {
    const float rounding = ImGui::GetStyle().FrameRounding;
    if (lit) list.AddRect(low, high, packed(theme.accent), rounding, 0, 2 * scale);
    if (current)
        list.AddRectFilled({low.x, low.y + 6 * scale}, {low.x + 3 * scale, high.y - 6 * scale},
                           packed(theme.accent), 1.5F * scale);
}

bool ScenarioList::draw_card(const Card& card, bool lit, bool current, const FrameContext& context) {
    const float scale = context.scale, pad = card_pad * scale;
    const ImVec2 size = card_size(scale), at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Selectable(("##" + card.choice.name).c_str(), lit || current, 0, size);
    remember_item(context.items,
                  card.choice.file ? "recent=" + card.choice.name : "scenario=" + card.choice.name);
    if (!ImGui::IsItemVisible()) return pressed;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low{at.x + pad, at.y + pad}, high{at.x + size.x - pad, low.y + thumbnail_height * scale};
    const auto place = card.choice.file ? std::nullopt : thumbnails_.find(card.choice.name);
    const float mat = 3 * scale; // around pictures, which are dark also in the light theme
    const ImVec2 outer_low{low.x - mat, low.y - mat}, outer_high{high.x + mat, high.y + mat};
    list.AddRectFilled(outer_low, outer_high, packed(context.theme.background), 4 * scale);
    list.AddRect(outer_low, outer_high, packed(context.theme.border), 4 * scale, 0, std::max(1.0F, scale));
    if (place)
        list.AddImageRounded(place->texture(), low, high, place->low, place->high, IM_COL32_WHITE, 3 * scale);
    else
        draw_no_picture(list, low, high, context.theme, scale);
    mark_card(list, at, {at.x + size.x, at.y + size.y}, lit, current, context.theme, scale);
    draw_title(list, {low.x, high.y + pad}, size.x - 2 * pad, card.title, context.theme);
    return pressed;
}

std::optional<ScenarioChoice> ScenarioList::draw_cards(const std::vector<Card>& cards, int columns,
                                                       const DocumentRun& run, const FrameContext& context) {
    std::optional<ScenarioChoice> chosen;
    std::string_view group;
    int column = 0;
    for (std::size_t i = 0; i < cards.size(); ++i) {
        const Card& card = cards[i];
        if (card.group != group) {
            group = card.group, column = 0;
            ImGui::Spacing();
            ImGui::TextColored(to_imgui(context.theme.accent), "%s", card.group.c_str());
        } else if (column > 0) {
            ImGui::SameLine(0, card_gap * context.scale);
        }
        column = (column + 1) % columns;
        const bool lit = static_cast<int>(i) == marked_;
        const bool current =
            !card.choice.file && run.scenario.name == card.choice.name && run.scenario.modified.empty();
        if (draw_card(card, lit, current, context)) chosen = card.choice;
        if (ImGui::IsItemHovered()) hovered_ = static_cast<int>(i);
        if (lit && scroll_to_mark_) ImGui::SetScrollHereY(0.5F);
    }
    if (cards.empty()) ImGui::TextDisabled("No scenario matches.");
    return chosen;
}

void ScenarioList::open(const Catalogue& catalogue) {
    if (shipped_.empty()) {
        for (const BuiltinScenario& one : builtin_scenarios())
            shipped_.push_back(find_scenario(catalogue, std::string(one.name)));
        std::stable_sort(shipped_.begin(), shipped_.end(), [](const Scenario& a, const Scenario& b) {
            return place_of(a.name) < place_of(b.name);
        });
    }
    if (ImGui::IsWindowAppearing())
        search_.clear(), marked_ = -1, opening_ = true, ImGui::SetKeyboardFocusHere();
}

std::optional<ScenarioChoice> ScenarioList::draw(const Catalogue& catalogue, const DocumentRun& run,
                                                 const std::vector<std::string>& recent, float width,
                                                 const FrameContext& context) {
    thumbnails_.begin_frame();
    ImGui::SetNextItemWidth(width);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float em = ImGui::GetFontSize(), beside = 2 * style.WindowPadding.x + style.ScrollbarSize;
    const int columns = columns_within(display.x - em - beside, context.scale);
    const float wide = static_cast<float>(columns) * (card_size(context.scale).x + card_gap * context.scale);
    const float high = display.y - 4 * em;
    ImGui::SetNextWindowSizeConstraints({std::min(wide + beside, display.x), 0}, {FLT_MAX, high});
    const bool opened = ImGui::BeginCombo("##scenario", run.title.c_str(), ImGuiComboFlags_HeightLargest);
    remember_item(context.items, "scenario");
    if (!opened) {
        opening_ = false;
        return {};
    }
    open(catalogue);
    ImGui::Spacing();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const std::string before = search_;
    const bool entered = ImGui::InputTextWithHint("##search", "Search; arrow keys and Enter choose", &search_,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    remember_item(context.items, "scenario.search");
    if (ImGui::IsItemActive()) opening_ = false;
    // The field takes this key, which is meant for the list.
    const bool left = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    const std::vector<Card> shown = cards(recent);
    if (search_ != before) marked_ = search_.empty() || shown.empty() ? -1 : 0;
    move_mark(shown, columns);
    std::optional<ScenarioChoice> chosen;
    if (entered && marked_ >= 0) chosen = shown[static_cast<std::size_t>(marked_)].choice;
    hovered_ = -1;
    const float foot = ImGui::GetFrameHeightWithSpacing();
    ImGui::BeginChild("##cards", {0, high - foot - 3 * ImGui::GetFrameHeightWithSpacing()});
    if (auto one = draw_cards(shown, columns, run, context)) chosen = std::move(one);
    ImGui::EndChild();
    // One line about the card under the mouse or the mark.
    const int about = hovered_ >= 0 ? hovered_ : marked_;
    const std::string text = about >= 0 ? shown[static_cast<std::size_t>(about)].text : std::string();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shortened(text, wide).c_str());
    if (chosen || left) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
    return chosen;
}

} // namespace gaspard
