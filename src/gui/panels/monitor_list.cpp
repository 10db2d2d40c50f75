#include "gui/panels/monitor_list.hpp"

#include "core/session/snapshot.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/panels/math_text.hpp"
#include "gui/panels/parameter_panel.hpp"

#include <algorithm>
#include <imgui.h>
#include <initializer_list>

namespace gaspard {

namespace {

/// In the current font.
struct ListSizes {
    float em = ImGui::GetFontSize();
    float picture_height = 3.2F * em;
    float picture_width = picture_height * monitor_picture_width / monitor_picture_height;
    float pad = 0.25F * em;
    float row = picture_height + 2 * pad;
    float text = picture_width + 0.9F * em; ///< where texts begin
    float wide = 33 * em;
};

/// Around the domain in which the monitor is known.
Box region_of(SectionKind kind, const PanelContext& context) {
    const Box square{{0, 0, 0}, {1, 1, 0}};
    if (context.snapshot == nullptr) return square;
    const auto& target = context.snapshot->target;
    return kind == SectionKind::monitor && target ? bounding_box(*target)
                                                  : bounding_box(context.snapshot->mesh->nodes);
}

/// What stands for a monitor that has no picture.
const char* sign_of(const MonitorType& type) {
    if (type.name == "formula") return "f(x)";
    if (type.name == "combine") return "m₁ + m₂";
    if (type.name == "derived") return "m(u)";
    if (type.name == "image" || type.name == "field") return "file";
    return type.make_tensor ? "M(x)" : "m(x)";
}

void draw_picture(ImDrawList& list, const std::optional<PicturePlace>& place, const char* sign, ImVec2 low,
                  ImVec2 high, float opacity, const Theme& theme) {
    const float rounding = ImGui::GetStyle().FrameRounding / 2;
    list.AddRectFilled(low, high, packed(theme.frame), rounding);
    if (place)
        return list.AddImageRounded(place->texture(), low, high, place->low, place->high,
                                    packed({1, 1, 1, opacity}), rounding);
    const ImVec2 size = text_size(sign);
    list.AddText({(low.x + high.x - size.x) / 2, (low.y + high.y - size.y) / 2},
                 packed(theme.faint_text, opacity), sign);
}

/// The formula, or what says as much in the list, where the whole of it is too long.
std::string short_equation(const MonitorType& type) {
    if (type.name == "combine") return "m(x) = t_a + t_b, t_a t_b, max(t_a, t_b) or min(t_a, t_b)";
    if (type.name == "sine-waves") return "m(x) = 1 + Σᵢ A exp( -B |y - yᵢ - aᵢ sin(2 π x)| )";
    return type.equation;
}

/// Without its last clause, such as ", γ = 1/N⁴", that is not within brackets; empty if there is only one.
std::string without_last_clause(const std::string& equation) {
    int depth = 0;
    for (std::size_t i = equation.size(); i-- > 0;) {
        const char c = equation[i];
        depth += c == ')' || c == '}' ? 1 : c == '(' || c == '{' ? -1 : 0;
        if (depth == 0 && (c == ',' || c == ';')) return equation.substr(0, i);
    }
    return {};
}

/// As much of the text as fits.
std::string beginning(const std::string& text, float width) {
    if (text_size(text).x <= width) return text;
    std::string part = text;
    while (!part.empty() && text_size(part + " …").x > width)
        part.resize(part.find_last_of(' ') == std::string::npos ? 0 : part.find_last_of(' '));
    return part + " …";
}

/// Typeset if it fits, else as text.
void draw_formula(ImDrawList& list, const MonitorType& type, ImVec2 at, ImVec2 room, float opacity,
                  const Theme& theme) {
    Colour ink = theme.faint_text;
    ink.a *= opacity;
    const auto listed = listed_formula(type, room);
    if (listed && listed->typeset) {
        const MathSize whole = math_size(*parse_math(listed->text), listed->size);
        return draw_math(list, *parse_math(listed->text), {at.x, at.y + (room.y - whole.height()) / 2},
                         listed->size, ink);
    }
    write_text(list, {at.x, at.y + (room.y - ImGui::GetFontSize()) / 2}, ink,
               listed ? listed->text : beginning(short_equation(type), room.x));
}

} // namespace

std::optional<ListedFormula> listed_formula(const MonitorType& type, ImVec2 room) {
    const float em = ImGui::GetFontSize();
    const auto typeset = [&](std::initializer_list<float> sizes) -> std::optional<ListedFormula> {
        for (std::string text = short_equation(type); !text.empty(); text = without_last_clause(text)) {
            const auto parsed = parse_math(text);
            for (const float size : sizes) {
                const MathSize whole = parsed ? math_size(*parsed, size * em) : MathSize{};
                if (parsed && whole.width <= room.x && whole.height() <= room.y)
                    return ListedFormula{text, size * em};
            }
        }
        return std::nullopt;
    };
    if (auto listed = typeset({0.95F, 0.85F, 0.75F})) return listed;
    if (auto listed = typeset({0.65F})) return listed; // rather than as text
    for (std::string text = short_equation(type); !text.empty(); text = without_last_clause(text))
        if (text_size(text).x <= room.x) return ListedFormula{std::move(text), em, false};
    return std::nullopt;
}

ImVec2 MonitorList::formula_room() {
    const ListSizes sizes;
    return {sizes.wide - sizes.text - sizes.pad, sizes.picture_height - 1.25F * sizes.em};
}

float MonitorList::width() { return ListSizes().wide; }

std::optional<Scenario> MonitorList::draw(SectionKind kind, const PanelContext& context,
                                          const Scenario& scenario) {
    const std::string& current = section_of(scenario, kind).type;
    const Box region = region_of(kind, context);
    std::vector<Entry> entries;
    for (const MonitorType& type : context.catalogue.monitors) {
        Entry entry{&type, with_type(context.catalogue, context.opened, scenario, kind, type.name), false};
        entry.selected = type.name == current;
        entries.push_back(std::move(entry));
    }
    std::stable_partition(entries.begin(), entries.end(), [](const Entry& one) { return one.possible(); });
    std::optional<Scenario> chosen;
    for (Entry& entry : entries) {
        const Scenario& shown = entry.candidate && !entry.selected ? *entry.candidate : scenario;
        if (draw_entry(kind, context, entry, shown, region) && entry.candidate && !entry.selected)
            chosen = std::move(entry.candidate);
    }
    return chosen;
}

bool MonitorList::draw_entry(SectionKind kind, const PanelContext& context, const Entry& entry,
                             const Scenario& shown, const Box& region) {
    const ListSizes sizes;
    const MonitorType& type = *entry.type;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float wide = ImGui::GetContentRegionAvail().x;
    const auto flags = entry.possible() ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    const bool pressed = ImGui::Selectable(("##" + type.name).c_str(), entry.selected, flags, {0, sizes.row});
    remember_item(context.items, std::string(section_key(kind)) + ".type=" + type.name);
    if (!entry.possible() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("cannot be combined with the other sections");
    if (!ImGui::IsItemVisible()) return pressed;
    std::optional<PicturePlace> place;
    if (entry.possible()) {
        const Space space = kind == SectionKind::monitor ? space_of(context.catalogue, shown)
                                                         : source_space_of(context.catalogue, shown);
        place =
            pictures_.find(type, {type.name, section_of(shown, kind).values, space, region, context.colours},
                           has_section(shown, SectionKind::pde) ? &shown.pde.values : nullptr);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float opacity = entry.possible() ? 1 : 0.4F;
    const ImVec2 low{at.x + sizes.pad, at.y + sizes.pad}, name{at.x + sizes.text, low.y};
    draw_picture(list, place, sign_of(type), low, {low.x + sizes.picture_width, low.y + sizes.picture_height},
                 opacity, context.theme);
    list.AddText(name, packed(context.theme.text, opacity), type.label.c_str());
    const float beside = text_size(type.label).x + sizes.em, room = wide - sizes.text - sizes.pad;
    list.AddText({name.x + beside, name.y}, packed(context.theme.faint_text, opacity),
                 beginning(type.help, room - beside).c_str());
    draw_formula(list, type, {name.x, name.y + 1.25F * sizes.em},
                 {room, sizes.picture_height - 1.25F * sizes.em}, opacity, context.theme);
    return pressed;
}

} // namespace gaspard
