#include "gui/panels/parameter_panel.hpp"

#include "core/base/error.hpp"
#include "core/scenario/time_rows.hpp"
#include "gui/base/icons.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/base/value_text.hpp"
#include "gui/panels/equation_box.hpp"
#include "gui/panels/formula_rows.hpp"
#include "gui/panels/panel_columns.hpp"
#include "gui/panels/slider_scale.hpp"
#include "gui/panels/value_field.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <functional>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <iterator>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

/// Beside the panel, so that it does not cover the row that it explains.
void show_tooltip(const std::string& title, const std::string& help, const std::string& details, float top) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({ImGui::GetWindowPos().x + ImGui::GetWindowWidth() + 0.5F * em, top - 0.6F * em});
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0F); // also that of a row that is disabled
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24 * em);
    ImGui::TextUnformatted(title.c_str());
    if (!help.empty()) ImGui::TextWrapped("%s", help.c_str());
    ImGui::TextDisabled("%s", details.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

std::string details_of(const ParameterRow& row, const std::string& key) {
    return key + "\n" + range_text(row) + "; default " + value_text(row, row.default_value) +
           (row.unit.empty() || !unit_text(row).empty() ? "" : "; unit: " + row.unit);
}

/// Whether a row is one wide field.
bool is_number(const ParameterRow& row) {
    return row.kind == ParameterKind::real || row.kind == ParameterKind::integer ||
           row.kind == ParameterKind::real_or_auto;
}

/// Whether the mouse is over a row, from its label to its text field.
bool row_hovered(ImVec2 corner, const PanelColumns& c) {
    const ImVec2 end(ImGui::GetWindowPos().x + c.end, corner.y + ImGui::GetFrameHeight());
    return ImGui::IsMouseHoveringRect(corner, end) && ImGui::IsWindowHovered() && !ImGui::IsMouseDown(0);
}

void draw_label(const std::string& label, const std::string& symbol, float width) {
    ImGui::AlignTextToFramePadding();
    const std::string text = shortened(label, width);
    ImGui::TextUnformatted(text.c_str());
    const float gap = 0.4F * ImGui::GetFontSize();
    if (symbol.empty() || text_size(text).x + gap + text_size(symbol).x > width) return;
    ImGui::SameLine(0, gap);
    ImGui::TextDisabled("%s", symbol.c_str());
}

bool reset_button(const char* id) {
    const float height = ImGui::GetFrameHeight(), width = 1.35F * ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(id, {width, height});
    const ImU32 colour = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    draw_icon(*ImGui::GetWindowDrawList(), Icon::reset, {at.x + width / 2, at.y + height / 2}, 0.5F * height,
              colour);
    return clicked;
}

/// Whether `values` has the row's key with the same range: the rows of a monitor depend on the domain.
bool has_same_row(const Values& values, const ParameterRow& row) {
    const auto& rows = values.rows();
    return std::any_of(rows.begin(), rows.end(), [&](const ParameterRow& one) {
        return one.key == row.key && one.minimum == row.minimum && one.maximum == row.maximum;
    });
}

/// The stages of a monitor; none for other sections.
std::vector<MonitorStage> stages_of(const Catalogue& catalogue, SectionKind kind, const std::string& type) {
    if (kind == SectionKind::monitor)
        for (const MonitorType& one : catalogue.monitors)
            if (one.name == type) return one.stages;
    return {};
}

bool belongs_to(const ParameterRow& row, const MonitorStage& stage) {
    return std::any_of(stage.keys.begin(), stage.keys.end(), [&](const std::string& key) {
        return key.ends_with('.') ? row.key.starts_with(key) : row.key == key;
    });
}

/// The row that switches a stage; null if there is none.
const ParameterRow* switch_of(const std::vector<ParameterRow>& rows, const MonitorStage& stage) {
    for (const ParameterRow& row : rows)
        if (row.key == stage.keys.front() && row.kind == ParameterKind::boolean) return &row;
    return nullptr;
}

/// Below the heading of part "a", "a: Amplitude" is called "Amplitude".
ParameterRow without_prefix(ParameterRow row) {
    const std::string part = row.key.substr(0, row.key.find('.')) + ": ";
    if (row.label.starts_with(part)) row.label.erase(0, part.size());
    return row;
}

/// The values that the monitor offers for a row of text; null if it offers none.
const std::vector<std::string>* choices_of(const PanelContext& context, const Values& values,
                                           const std::string& row) {
    if (!context.report || values.section() != "monitor") return nullptr;
    const auto found = context.report->choices.find(row);
    return found == context.report->choices.end() || found->second.empty() ? nullptr : &found->second;
}

/// Whether a row can have a value: a colour of another method is none of its choices.
bool allows(const ParameterRow& row, const Value& value) {
    const auto* choice = std::get_if<std::string>(&value);
    return row.kind != ParameterKind::choice ||
           (choice && std::find(row.choices.begin(), row.choices.end(), *choice) != row.choices.end());
}

/// What a list calls a choice; an empty text is called automatic.
std::string name_of(const ParameterRow& row, const std::string& choice) {
    const auto found = std::find(row.choices.begin(), row.choices.end(), choice);
    const auto place = static_cast<std::size_t>(found - row.choices.begin());
    if (place < row.choice_labels.size()) return row.choice_labels[place];
    return choice.empty() ? "automatic" : choice;
}

/// The list of a choice. `fits`: the others are greyed out.
std::optional<std::string> draw_list(const PanelContext& context, const std::string& key,
                                     const ParameterRow& row, const std::string& current,
                                     const std::vector<std::string>& choices,
                                     const std::function<bool(const std::string&)>& fits) {
    std::optional<std::string> chosen;
    const bool open =
        ImGui::BeginCombo("##choice", name_of(row, current).c_str(), ImGuiComboFlags_HeightLarge);
    remember_item(context.items, key);
    if (!open) return chosen;
    for (const auto& choice : choices) {
        const auto flags = fits(choice) ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
        const std::string name = name_of(row, choice);
        if (ImGui::Selectable(name.c_str(), choice == current, flags) && fits(choice)) chosen = choice;
        remember_item(context.items, key + "=" + choice);
    }
    ImGui::EndCombo();
    return chosen;
}

void draw_quietly(const std::string& text) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

/// The sentences of a monitor, below its rows.
void draw_notes(const MonitorReport& report, ItemRectangles& items) {
    for (std::size_t i = 0; i < report.notes.size(); ++i) {
        draw_quietly(report.notes[i]);
        remember_item(items, "monitor.note." + std::to_string(i));
    }
}

/// Whether a choice can be combined with the rest of the scenario. Without a scenario, all can.
bool choice_fits(const PanelContext& context, const Scenario* scenario, const Values& values,
                 const std::string& key, const std::string& choice) {
    const auto& missing = context.unavailable;
    if (std::find(missing.begin(), missing.end(), key + "=" + choice) != missing.end()) return false;
    if (!scenario || values.section() != "domain") return true;
    Scenario candidate = *scenario;
    candidate.domain.values.set(key, choice);
    return find_capability(context.catalogue, candidate) != nullptr;
}

} // namespace

/// The open list of types.
bool ParameterPanel::draw_types(SectionKind kind, const PanelContext& context, Scenario& scenario) {
    if (kind == SectionKind::monitor || kind == SectionKind::source) {
        auto chosen = monitors_.draw(kind, context, scenario);
        if (chosen) scenario = std::move(*chosen);
        return chosen.has_value();
    }
    const std::string key = std::string(section_key(kind)) + ".type",
                      current = section_of(scenario, kind).type;
    std::optional<Scenario> chosen;
    for (const auto& entry : type_entries(context.catalogue, kind)) {
        auto candidate = with_type(context.catalogue, context.opened, scenario, kind, *entry.name);
        const bool selected = *entry.name == current, possible = candidate || selected;
        const auto flags = possible ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
        if (ImGui::Selectable(entry.label->c_str(), selected, flags) && candidate && !selected)
            chosen = std::move(candidate);
        remember_item(context.items, key + "=" + *entry.name);
        if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
            ImGui::SetTooltip("%s",
                              possible ? entry.help->c_str() : "cannot be combined with the other sections");
    }
    if (chosen) scenario = std::move(*chosen);
    return chosen.has_value();
}

bool ParameterPanel::draw_section(SectionKind kind, const PanelContext& context, Scenario& scenario) {
    const std::string key = std::string(section_key(kind)) + ".type";
    const auto entries = type_entries(context.catalogue, kind);
    const std::string current = section_of(scenario, kind).type;
    const auto shown =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return *e.name == current; });
    bool changed = false;

    ImGui::PushID(key.c_str());
    const PanelColumns c = columns();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    draw_label("Type", "", c.control - c.field);
    ImGui::SameLine(c.control);
    ImGui::SetNextItemWidth(c.wide());
    const float free = c.wide() - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
    const bool pictures = kind == SectionKind::monitor || kind == SectionKind::source;
    if (pictures)
        ImGui::SetNextWindowSizeConstraints({MonitorList::width(), 0},
                                            {FLT_MAX, 0.8F * ImGui::GetIO().DisplaySize.y});
    const bool open = ImGui::BeginCombo(
        "##type", shortened(shown == entries.end() ? current : *shown->label, free).c_str());
    remember_item(context.items, key);
    if (shown != entries.end() && row_hovered(corner, c))
        show_tooltip(*shown->label, *shown->help, key, corner.y);
    if (open) {
        changed = draw_types(kind, context, scenario);
        ImGui::EndCombo();
    }
    const Section& section = section_of(scenario, kind);
    const std::string equation = equation_of(context.catalogue, kind, section);
    const bool typed = find_role(section.values.rows(), ParameterRole::formula) != nullptr;
    const bool moves = kind == SectionKind::monitor && context.monitor_now != nullptr;
    draw_equation_box(equation,
                      moves ? values_at_time(*context.monitor_now, context.now)
                            : values_by_symbol(section.values),
                      c.end - c.field, context.theme, !typed);
    if (!equation.empty()) remember_item(context.items, std::string(section_key(kind)) + ".equation");
    changed |= draw_section_rows(kind, context, scenario);
    if (kind == SectionKind::monitor && !context.warning.empty()) {
        ImGui::PushTextWrapPos(c.end);
        ImGui::TextColored(to_imgui(context.theme.warning), "%s", context.warning.c_str());
        ImGui::PopTextWrapPos();
        remember_item(context.items, "monitor.warning");
    }
    if (kind == SectionKind::monitor && context.report) draw_notes(*context.report, context.items);
    ImGui::PopID();
    return changed;
}

bool ParameterPanel::draw_section_rows(SectionKind kind, const PanelContext& context, Scenario& scenario) {
    const Section& section = section_of(scenario, kind);
    const std::vector<MonitorStage> stages = stages_of(context.catalogue, kind, section.type);
    std::vector<ParameterRow> rows = section.values.rows(); // a copy: a choice may replace the section
    const auto of_stage = [](const MonitorStage& stage) {
        return [&stage](const ParameterRow& row) { return belongs_to(row, stage); };
    };
    bool changed = false;
    const auto draw = [&](const ParameterRow& row) { // true: the rows are other ones now
        const Drawn drawn = draw_scenario_row(kind, context, row, scenario);
        changed |= drawn != Drawn::unchanged;
        return drawn == Drawn::other_rows;
    };
    const Section& opened = section_of(context.opened, kind);
    std::vector<ParameterRow> own_rows;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(own_rows), [&](const ParameterRow& row) {
        return std::none_of(stages.begin(), stages.end(),
                            [&](const MonitorStage& one) { return belongs_to(row, one); });
    });
    const Values* before = opened.type == section.type ? &opened.values : nullptr;
    for (const ParameterRow& row : rows_in_sight(own_rows, before, section.values))
        if (draw(row)) return true;
    draw_more(context, section.values.section());
    for (const MonitorStage& stage : stages) {
        std::vector<ParameterRow> own;
        std::copy_if(rows.begin(), rows.end(), std::back_inserter(own), of_stage(stage));
        if (own.empty()) continue;
        Values& values = section_of(scenario, kind).values;
        const ParameterRow* toggle = switch_of(own, stage);
        changed |= draw_stage(context, stage, toggle, values);
        const bool on = toggle == nullptr || values.boolean(toggle->key);
        ImGui::BeginDisabled(!on);
        bool other_rows = false;
        for (const ParameterRow& row : own)
            if (&row != toggle && !other_rows) other_rows = draw(without_prefix(row));
        ImGui::EndDisabled();
        if (other_rows) return true;
    }
    return changed;
}

/// Draws one row and, if it changes what rows there are, updates them.
ParameterPanel::Drawn ParameterPanel::draw_scenario_row(SectionKind kind, const PanelContext& context,
                                                        const ParameterRow& row, Scenario& scenario) {
    const Section& opened = section_of(context.opened, kind);
    Section& section = section_of(scenario, kind);
    if (kind == SectionKind::monitor && row.role == ParameterRole::time && has_time(scenario.time)) {
        draw_clock_row(context, row, section.values);
        return Drawn::unchanged;
    }
    const Values* before =
        opened.type == section.type && has_same_row(opened.values, row) ? &opened.values : nullptr;
    const bool changed = draw_row(context, row, before, section.values, &scenario);
    if (!changed) return Drawn::unchanged;
    if (!redefines_rows(row)) return Drawn::changed;
    update_typed_rows(context.catalogue, scenario);
    return Drawn::other_rows;
}

/// A time of the monitor while time passes: that of the mesh that is shown.
void ParameterPanel::draw_clock_row(const PanelContext& context, const ParameterRow& row,
                                    const Values& values) {
    Values now = values;
    if (context.monitor_now != nullptr && context.monitor_now->has(row.key))
        now.set(row.key, context.monitor_now->at(row.key));
    const Values origin = now; // nothing to reset
    ParameterRow told = row;
    told.help += std::string(told.help.empty() ? "" : "\n") +
                 "The time of the mesh that is shown: it goes from Start to End of the section Time.";
    ImGui::BeginDisabled();
    draw_row(context, told, &origin, now, nullptr);
    ImGui::EndDisabled();
}

/// The heading of a stage: an eye that shows its result, its name, and its switch. True if that was used.
bool ParameterPanel::draw_stage(const PanelContext& context, const MonitorStage& stage,
                                const ParameterRow* toggle, Values& values) {
    const std::string key = values.section() + ".stage." + stage.label;
    const bool shown = context.shown_field == stage.field;
    ImGui::PushID(key.c_str());
    ImGui::Spacing();
    const Colour colour = shown ? context.theme.accent : context.theme.faint_text;
    if (eye_button("##eye", false, packed(colour), packed(context.theme.text))) field_wish_ = stage.field;
    remember_item(context.items, key);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Colour the mesh by the result of this stage");
    ImGui::SameLine(0, 0.3F * ImGui::GetFontSize());
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(to_imgui(shown ? context.theme.accent : context.theme.text), "%s",
                       stage.label.c_str());
    bool changed = false;
    if (toggle != nullptr) {
        bool on = values.boolean(toggle->key);
        const std::string switched = values.section() + "." + toggle->key;
        ImGui::SameLine(columns().control);
        changed = ImGui::Checkbox("##on", &on);
        if (changed) values.set(toggle->key, on);
        remember_item(context.items, switched);
        if (ImGui::IsItemHovered())
            show_tooltip(toggle->label, toggle->help, details_of(*toggle, switched),
                         ImGui::GetItemRectMin().y);
    }
    ImGui::PopID();
    return changed;
}

bool ParameterPanel::draw_rows(const PanelContext& context, const Values& opened, Values& values,
                               const std::vector<std::string>& keys, const Scenario* scenario) {
    bool changed = false;
    std::vector<ParameterRow> rows;
    std::copy_if(
        values.rows().begin(), values.rows().end(), std::back_inserter(rows),
        [&](const ParameterRow& row) { return std::find(keys.begin(), keys.end(), row.key) != keys.end(); });
    for (const ParameterRow& row : rows_in_sight(rows, &opened, values))
        changed |= draw_row(context, row, &opened, values, scenario);
    draw_more(context, values.section());
    return changed;
}

/// Without details that have their usual values, unless the section shows all.
std::vector<ParameterRow> ParameterPanel::rows_in_sight(const std::vector<ParameterRow>& rows,
                                                        const Values* opened, const Values& values) {
    constexpr std::size_t most = 8; // of those that are no details
    std::vector<ParameterRow> shown;
    hidden_rows_ = 0;
    std::size_t plain = 0;
    for (const ParameterRow& row : rows) {
        const Value& origin = opened && has_same_row(*opened, row) ? opened->at(row.key) : row.default_value;
        const bool changed = values.at(row.key) != origin || values.at(row.key) != row.default_value;
        const bool detail = row.detail || (!redefines_rows(row) && ++plain > most);
        if (detail && !changed) ++hidden_rows_;
        if (!detail || changed || opened_.contains(values.section())) shown.push_back(row);
    }
    return shown;
}

/// Shows or hides the rows that are not in sight, if there are any.
void ParameterPanel::draw_more(const PanelContext& context, const std::string& section) {
    if (hidden_rows_ == 0) return;
    const bool open = opened_.contains(section);
    const std::string label = open ? "Less" : std::string("More") + " (" + std::to_string(hidden_rows_) + ")";
    const float width = text_size(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SetCursorPosX(std::max(0.0F, columns().end - width));
    ImGui::PushStyleColor(ImGuiCol_Button, {0, 0, 0, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(context.theme.faint_text));
    ImGui::PushID(section.c_str());
    if (ImGui::SmallButton((label + "###more").c_str())) {
        if (open)
            opened_.erase(section);
        else
            opened_.insert(section);
    }
    ImGui::PopID();
    ImGui::PopStyleColor(2);
    remember_item(context.items, section + ".more");
}

bool ParameterPanel::draw_row(const PanelContext& context, const ParameterRow& row, const Values* opened,
                              Values& values, const Scenario* scenario) {
    const std::string key = values.section() + "." + row.key;
    const PanelColumns c = columns();
    const Value before = values.at(row.key);
    ImGui::PushID(key.c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool formula = scenario != nullptr && is_formula(row),
               motion = scenario != nullptr && is_motion(values, row);
    if (!is_number(row)) draw_label(row.label, row.symbol, c.control - c.field - 0.3F * ImGui::GetFontSize());
    if (formula) {
        draw_formula(context, row, key, values, *scenario);
    } else {
        if (!is_number(row)) ImGui::SameLine(c.control);
        if (motion)
            draw_motion(context, row, key, values, *scenario);
        else
            draw_control(context, row, key, opened, values, scenario);
    }
    if (row_hovered(corner, c)) show_tooltip(row.label, row.help, details_of(row, key), corner.y);
    const Value& origin =
        opened && allows(row, opened->at(row.key)) ? opened->at(row.key) : row.default_value;
    const bool draft = formulas_.has_draft(key); // a formula that is not applied is taken back first
    if (values.at(row.key) != origin || draft) {
        const ImVec2 next = ImGui::GetCursorPos();
        ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x + c.reset - ImGui::GetScrollX(), corner.y});
        if (reset_button("##reset")) draft ? formulas_.restore(key) : values.set(row.key, origin);
        remember_item(context.items, key + ".reset");
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", draft ? "Back to the formula in use"
                                          : ("Reset to " + value_text(row, origin)).c_str());
        if (formula || motion) ImGui::SetCursorPos(next);
    }
    if (row.role == ParameterRole::file && values.section() == "monitor" && values.text(row.key).empty())
        draw_quietly("Drop a file onto the window, or choose one.");
    ImGui::PopID();
    return values.at(row.key) != before;
}

void ParameterPanel::draw_control(const PanelContext& context, const ParameterRow& row,
                                  const std::string& key, const Values* opened, Values& values,
                                  const Scenario* scenario) {
    const float wide = columns().wide();
    switch (row.kind) {
    case ParameterKind::real:
    case ParameterKind::integer: {
        double number = number_of(values, row);
        const PanelColumns c = columns();
        if (draw_number(context, row, key, number, c.end - c.field)) set_number(values, row, number);
        return;
    }
    case ParameterKind::real_or_auto:
        return draw_number_or_auto(context, row, key, opened, values);
    case ParameterKind::boolean: {
        bool on = values.boolean(row.key);
        if (ImGui::Checkbox("##on", &on)) values.set(row.key, on);
        remember_item(context.items, key);
        return;
    }
    case ParameterKind::choice: {
        const std::string current = values.text(row.key);
        const auto fits = [&](const std::string& choice) {
            return choice == current || choice_fits(context, scenario, values, row.key, choice);
        };
        ImGui::SetNextItemWidth(wide);
        if (const auto chosen = draw_list(context, key, row, current, row.choices, fits))
            values.set(row.key, *chosen);
        return;
    }
    case ParameterKind::text:
        ImGui::SetNextItemWidth(wide);
        return draw_text(context, row, key, values);
    }
}

/// A list of patches, whose values are their numbers from 1.
static void draw_patches(const PanelContext& context, const PatchList& patches, const std::string& key,
                         const ParameterRow& row, Values& values) {
    const bool open = ImGui::BeginCombo("##patch", patches.labels[patches.chosen].c_str());
    remember_item(context.items, key);
    if (!open) return;
    for (std::size_t i = 0; i < patches.labels.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        if (ImGui::Selectable(patches.labels[i].c_str(), i == patches.chosen)) values.set(row.key, number);
        remember_item(context.items, key + "=" + number);
    }
    ImGui::EndCombo();
}

/// A text takes effect when its field is left, since a part of a name would be invalid.
void ParameterPanel::draw_text(const PanelContext& context, const ParameterRow& row, const std::string& key,
                               Values& values) {
    const std::string& value = values.text(row.key);
    if (row.role == ParameterRole::patch && context.patches != nullptr)
        return draw_patches(context, *context.patches, key, row, values);
    if (row.role == ParameterRole::file) {
        if (draw_file(key, value, ImGui::CalcItemWidth(), context.items))
            file_wish_ = {key, row.label, value};
        return;
    }
    if (const std::vector<std::string>* known = choices_of(context, values, row.key)) {
        std::vector<std::string> choices = *known;
        if (std::get<std::string>(row.default_value).empty()) choices.insert(choices.begin(), std::string());
        const auto chosen =
            draw_list(context, key, row, value, choices, [](const std::string&) { return true; });
        if (chosen) values.set(row.key, *chosen);
        return;
    }
    std::string shown = typing_ == key ? typed_text_ : value;
    const bool edited = ImGui::InputText("##text", &shown);
    remember_item(context.items, key);
    if (edited) typing_ = key, typed_text_ = shown;
    if (typing_ != key || ImGui::IsItemActive()) return;
    typing_.clear();
    values.set(row.key, typed_text_);
}

/// Another number when values have changed by which a formula that is not applied may become valid.
std::size_t ParameterPanel::situation_of(const std::string& key, const Scenario& scenario) {
    if (!formulas_.has_draft(key)) return situation_;
    const auto alike = [&](const Scenario& one) {
        return one.domain == scenario.domain && one.monitor == scenario.monitor &&
               one.source == scenario.source && one.pde == scenario.pde && one.method == scenario.method &&
               one.time == scenario.time;
    };
    if (!checked_for_ || !alike(*checked_for_)) checked_for_ = scenario, ++situation_;
    return situation_;
}

/// Below the label, in the whole width.
void ParameterPanel::draw_formula(const PanelContext& context, const ParameterRow& row,
                                  const std::string& key, Values& values, const Scenario& scenario) {
    const auto complaint_of = [&](const std::string& text) {
        return formula_complaint(context.catalogue, scenario, values.section(), row.key, text);
    };
    const std::vector<FormulaWord> words = formula_words(context.catalogue, scenario);
    const FormulaField::Context field{.theme = context.theme,
                                      .items = context.items,
                                      .words = words,
                                      .check = complaint_of,
                                      .situation = situation_of(key, scenario)};
    ImGui::SameLine(0, 0.6F * ImGui::GetFontSize());
    formulas_.draw_help(key, field);
    const auto applied = formulas_.draw(key, values.text(row.key), field);
    if (!applied) return;
    values.set(row.key, *applied);
    formula_applied_ = true;
}

/// Beside the label; what is wrong with it is below.
void ParameterPanel::draw_motion(const PanelContext& context, const ParameterRow& row, const std::string& key,
                                 Values& values, const Scenario& scenario) {
    const auto complaint_of = [&](const std::string& text) {
        return motion_complaint(scenario, row.key, text);
    };
    const std::vector<FormulaWord> no_list;
    const FormulaField::Context field{.theme = context.theme,
                                      .items = context.items,
                                      .words = no_list,
                                      .check = complaint_of,
                                      .width = columns().wide(),
                                      .least_lines = 1,
                                      .situation = situation_of(key, scenario)};
    const auto applied = formulas_.draw(key, values.text(row.key), field);
    if (!applied) return;
    values.set(row.key, *applied);
    formula_applied_ = true;
}

} // namespace gaspard
