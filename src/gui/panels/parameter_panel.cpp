#include "gui/panels/parameter_panel.hpp"

#include "core/base/check.hpp"
#include "gui/base/icons.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

/// Columns of a row: label, slider, text field, reset button. In window coordinates, scaled by the font.
struct Columns {
    float control, slider_width, typed, typed_width, reset;
};

Columns columns() {
    const float em = ImGui::GetFontSize(), gap = 0.45F * em;
    Columns c{};
    c.reset = ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight();
    c.typed_width = 4.8F * em;
    c.typed = c.reset - gap - c.typed_width;
    c.control = ImGui::GetWindowContentRegionMin().x + 8.9F * em;
    c.slider_width = std::max(2 * em, c.typed - gap - c.control);
    return c;
}

template <class AnyScenario>
auto& section_of(AnyScenario& scenario, SectionKind kind) {
    switch (kind) {
    case SectionKind::domain:
        return scenario.domain;
    case SectionKind::monitor:
        return scenario.monitor;
    case SectionKind::target:
        return scenario.target;
    case SectionKind::method:
        return scenario.method;
    case SectionKind::pde:
        return scenario.pde;
    }
    check_failed("the section has a kind");
}

const char* section_key(SectionKind kind) {
    switch (kind) {
    case SectionKind::domain:
        return "domain";
    case SectionKind::monitor:
        return "monitor";
    case SectionKind::target:
        return "monitor.target";
    case SectionKind::method:
        return "method";
    case SectionKind::pde:
        return "pde";
    }
    return "";
}

/// An entry in a list of types.
struct TypeEntry {
    const std::string *name, *label, *help;
};

std::vector<TypeEntry> type_entries(const Catalogue& catalogue, SectionKind kind) {
    std::vector<TypeEntry> entries;
    const auto add = [&](const auto& types) {
        for (const auto& type : types) entries.push_back({&type.name, &type.label, &type.help});
    };
    if (kind == SectionKind::domain)
        add(catalogue.domains);
    else if (kind == SectionKind::monitor || kind == SectionKind::target)
        add(catalogue.monitors);
    else if (kind == SectionKind::method)
        add(catalogue.methods);
    else
        add(catalogue.pdes);
    return entries;
}

Section fresh_section(const Catalogue& catalogue, const Scenario& opened, SectionKind kind,
                      const std::string& type) {
    if (const Section& before = section_of(opened, kind); before.type == type) return before;
    switch (kind) {
    case SectionKind::domain:
        return domain_section(catalogue, type);
    case SectionKind::monitor:
        return monitor_section(catalogue, type); // with the plane's rows; update_rows() adapts them
    case SectionKind::target:
        return monitor_section(catalogue, type, {}, section_key(kind));
    case SectionKind::method:
        return method_section(catalogue, type);
    case SectionKind::pde:
        return pde_section(catalogue, type);
    }
    return {};
}

double number_of(const Values& values, const ParameterRow& row) {
    return row.kind == ParameterKind::integer ? static_cast<double>(values.integer(row.key))
                                              : values.real(row.key);
}

void set_number(Values& values, const ParameterRow& row, double number) {
    if (row.kind == ParameterKind::integer)
        values.set(row.key, static_cast<std::int64_t>(std::llround(number)));
    else
        values.set(row.key, number);
}

/// The scale of a slider: the value, its logarithm, or, if the range is not positive, asinh, which is like a
/// logarithm for large values and is defined at zero.
double along(const ParameterRow& row, double value) {
    if (row.scale == ParameterScale::linear) return value;
    return row.minimum > 0 ? std::log(value) : std::asinh(value);
}

double position_of(const ParameterRow& row, double value) {
    const double low = along(row, row.minimum), high = along(row, row.maximum);
    return high > low ? (along(row, value) - low) / (high - low) : 0;
}

double value_at(const ParameterRow& row, double position) {
    const double low = along(row, row.minimum), high = along(row, row.maximum);
    const double place = low + position * (high - low);
    if (row.scale == ParameterScale::linear) return place;
    return row.minimum > 0 ? std::exp(place) : std::sinh(place);
}

/// A value of a slider, rounded to the precision of the mouse. Typed values are not rounded.
double rounded(const ParameterRow& row, double value) {
    if (row.kind == ParameterKind::integer) return std::round(value);
    const double size =
        row.scale == ParameterScale::logarithmic ? std::abs(value) * 10 : row.maximum - row.minimum;
    if (size == 0 || !std::isfinite(size)) return value;
    const double decimals = 3 - std::floor(std::log10(size));
    const double factor = std::pow(10.0, std::abs(decimals));
    return decimals >= 0 ? std::round(value * factor) / factor : std::round(value / factor) * factor;
}

/// Beside the panel, so that it does not cover the row that it explains.
void show_tooltip(const std::string& title, const std::string& help, const std::string& details, float top) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({ImGui::GetWindowPos().x + ImGui::GetWindowWidth() + 0.5F * em, top - 0.6F * em});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24 * em);
    ImGui::TextUnformatted(title.c_str());
    if (!help.empty()) ImGui::TextWrapped("%s", help.c_str());
    ImGui::TextDisabled("%s", details.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string details_of(const ParameterRow& row, const std::string& key) {
    const std::string unit = row.unit.empty() ? "" : " " + row.unit;
    return key + "\n" + describe_range(row) + unit + "; default " + format_value(row.default_value) + unit;
}

/// Whether the mouse is over a row, from its label to its text field.
bool row_hovered(ImVec2 corner, const Columns& c) {
    const ImVec2 end(ImGui::GetWindowPos().x + c.typed + c.typed_width, corner.y + ImGui::GetFrameHeight());
    return ImGui::IsMouseHoveringRect(corner, end) && ImGui::IsWindowHovered() && !ImGui::IsMouseDown(0);
}

void draw_label(const std::string& label, const std::string& symbol) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    if (symbol.empty()) return;
    ImGui::SameLine(0, 0.4F * ImGui::GetFontSize());
    ImGui::TextDisabled("%s", symbol.c_str());
}

bool reset_button(const char* id) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(id, {side, side});
    const ImU32 colour = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    draw_icon(*ImGui::GetWindowDrawList(), Icon::reset, {at.x + side / 2, at.y + side / 2}, 0.5F * side,
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

/// Whether a row can have a value: a colour of another method is none of its choices.
bool allows(const ParameterRow& row, const Value& value) {
    const auto* choice = std::get_if<std::string>(&value);
    return row.kind != ParameterKind::choice ||
           (choice && std::find(row.choices.begin(), row.choices.end(), *choice) != row.choices.end());
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

const char* section_title(SectionKind kind) {
    switch (kind) {
    case SectionKind::domain:
        return "Domain";
    case SectionKind::monitor:
        return "Monitor";
    case SectionKind::target:
        return "Target density";
    case SectionKind::method:
        return "Method";
    case SectionKind::pde:
        return "PDE";
    }
    return "";
}

bool has_section(const Scenario& scenario, SectionKind kind) {
    return !section_of(scenario, kind).type.empty();
}

std::optional<Scenario> with_type(const Catalogue& catalogue, const Scenario& opened,
                                  const Scenario& scenario, SectionKind kind, const std::string& type) {
    Scenario changed = scenario;
    section_of(changed, kind) = fresh_section(catalogue, opened, kind, type);
    update_rows(catalogue, changed);
    if (find_capability(catalogue, changed)) return changed;
    if (kind != SectionKind::domain) return std::nullopt;
    const auto row = std::find_if(catalogue.capabilities.begin(), catalogue.capabilities.end(),
                                  [&](const Capability& one) { return one.domain == type; });
    if (row == catalogue.capabilities.end()) return std::nullopt;
    const auto adapt = [&](SectionKind other, const std::vector<std::string>& allowed) {
        const std::string& present = section_of(changed, other).type;
        if (allowed.empty() || std::find(allowed.begin(), allowed.end(), present) != allowed.end()) return;
        section_of(changed, other) = fresh_section(catalogue, opened, other, allowed.front());
    };
    adapt(SectionKind::monitor, row->monitors);
    adapt(SectionKind::method, row->methods);
    update_rows(catalogue, changed);
    return find_capability(catalogue, changed) ? std::optional(std::move(changed)) : std::nullopt;
}

bool ParameterPanel::draw_section(SectionKind kind, const PanelContext& context, Scenario& scenario) {
    const std::string key = std::string(section_key(kind)) + ".type";
    const auto entries = type_entries(context.catalogue, kind);
    const std::string current = section_of(scenario, kind).type;
    const auto shown =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return *e.name == current; });
    bool changed = false;

    ImGui::PushID(key.c_str());
    const Columns c = columns();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    draw_label("Type", "");
    ImGui::SameLine(c.control);
    ImGui::SetNextItemWidth(c.typed + c.typed_width - c.control);
    const bool open =
        ImGui::BeginCombo("##type", shown == entries.end() ? current.c_str() : shown->label->c_str());
    remember_item(context.items, key);
    if (shown != entries.end() && row_hovered(corner, c))
        show_tooltip(*shown->label, *shown->help, key, corner.y);
    if (open) {
        for (const auto& entry : entries) {
            auto candidate = with_type(context.catalogue, context.opened, scenario, kind, *entry.name);
            const bool selected = *entry.name == current;
            const auto flags =
                candidate || selected ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
            if (ImGui::Selectable(entry.label->c_str(), selected, flags) && candidate && !selected) {
                scenario = std::move(*candidate);
                changed = true;
            }
            remember_item(context.items, key + "=" + *entry.name);
            if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
                ImGui::SetTooltip("%s", candidate || selected ? entry.help->c_str()
                                                              : "cannot be combined with the other sections");
        }
        ImGui::EndCombo();
    }
    const Section& opened = section_of(context.opened, kind);
    Section& section = section_of(scenario, kind);
    const std::vector<ParameterRow> rows = section.values.rows(); // a copy: a choice may replace the section
    for (const auto& row : rows) {
        const Values* before =
            opened.type == section.type && has_same_row(opened.values, row) ? &opened.values : nullptr;
        const bool set = draw_row(context, row, before, section.values, &scenario);
        changed |= set;
        if (!set || !redefines_rows(row)) continue;
        try {
            update_rows(context.catalogue, scenario);
        } catch (const InputError&) { // it is being typed; the run says what is wrong
        }
        break; // the rows are other ones now
    }
    ImGui::PopID();
    return changed;
}

bool ParameterPanel::draw_rows(const PanelContext& context, const Values& opened, Values& values,
                               const std::vector<std::string>& keys) {
    bool changed = false;
    const std::vector<ParameterRow> rows = values.rows();
    for (const auto& row : rows)
        if (std::find(keys.begin(), keys.end(), row.key) != keys.end())
            changed |= draw_row(context, row, &opened, values, nullptr);
    return changed;
}

bool ParameterPanel::draw_row(const PanelContext& context, const ParameterRow& row, const Values* opened,
                              Values& values, const Scenario* scenario) {
    const std::string key = values.section() + "." + row.key;
    const Columns c = columns();
    const float wide = c.typed + c.typed_width - c.control;
    const Value before = values.at(row.key);
    ImGui::PushID(key.c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    draw_label(row.label, row.symbol);
    ImGui::SameLine(c.control);
    switch (row.kind) {
    case ParameterKind::real:
    case ParameterKind::integer: {
        double number = number_of(values, row);
        if (draw_number(context, row, key, number)) set_number(values, row, number);
        break;
    }
    case ParameterKind::real_or_auto:
        draw_number_or_auto(context, row, key, opened, values);
        break;
    case ParameterKind::boolean: {
        bool on = values.boolean(row.key);
        if (ImGui::Checkbox("##on", &on)) values.set(row.key, on);
        remember_item(context.items, key);
        break;
    }
    case ParameterKind::choice: {
        const std::string current = values.text(row.key);
        ImGui::SetNextItemWidth(wide);
        const bool open = ImGui::BeginCombo("##choice", current.c_str());
        remember_item(context.items, key);
        if (!open) break;
        for (const auto& choice : row.choices) {
            const bool fits = choice == current || choice_fits(context, scenario, values, row.key, choice);
            const auto flags = fits ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
            if (ImGui::Selectable(choice.c_str(), choice == current, flags) && fits)
                values.set(row.key, choice);
            remember_item(context.items, key + "=" + choice);
        }
        ImGui::EndCombo();
        break;
    }
    case ParameterKind::text: {
        ImGui::SetNextItemWidth(wide);
        draw_text(context, row, key, values);
        break;
    }
    }
    if (row_hovered(corner, c)) show_tooltip(row.label, row.help, details_of(row, key), corner.y);

    const Value& origin =
        opened && allows(row, opened->at(row.key)) ? opened->at(row.key) : row.default_value;
    if (values.at(row.key) != origin) {
        ImGui::SameLine(c.reset);
        if (reset_button("##reset")) values.set(row.key, origin);
        remember_item(context.items, key + ".reset");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Reset to %s", format_value(origin).c_str());
    }
    ImGui::PopID();
    return values.at(row.key) != before;
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
    if (row.role == ParameterRole::patch && context.patches != nullptr)
        return draw_patches(context, *context.patches, key, row, values);
    std::string shown = typing_ == key ? typed_text_ : values.text(row.key);
    const bool edited = ImGui::InputText("##text", &shown);
    remember_item(context.items, key);
    if (edited) typing_ = key, typed_text_ = shown;
    if (typing_ != key || ImGui::IsItemActive()) return;
    typing_.clear();
    values.set(row.key, typed_text_);
}

// A check box for "auto"; if it is not ticked, a slider follows. Unticked, it restores the number that was there
// before, or with which the scenario was opened.
void ParameterPanel::draw_number_or_auto(const PanelContext& context, const ParameterRow& row,
                                         const std::string& key, const Values* opened, Values& values) {
    const Columns c = columns();
    const std::optional<double> number = values.real_or_auto(row.key);
    bool automatic = !number;
    const bool switched = ImGui::Checkbox("auto", &automatic);
    remember_item(context.items, key + ".auto");
    if (!number) {
        if (!switched) return;
        const std::optional<double> at_first = opened ? opened->real_or_auto(row.key) : std::nullopt;
        double restored = at_first.value_or(rounded(row, value_at(row, 0.5)));
        if (const auto before = before_auto_.find(key); before != before_auto_.end())
            restored = before->second;
        values.set(row.key, std::clamp(restored, row.minimum, row.maximum));
        return;
    }
    before_auto_[key] = *number;
    const float box = ImGui::GetItemRectSize().x + 0.5F * ImGui::GetFontSize();
    ImGui::SameLine(c.control + box);
    double typed = *number;
    if (draw_number(context, row, key, typed, box)) values.set(row.key, typed);
    if (switched) values.set(row.key, std::string("auto"));
}

bool ParameterPanel::draw_number(const PanelContext& context, const ParameterRow& row, const std::string& key,
                                 double& value, float taken) {
    const Columns c = columns();
    bool changed = false;
    const bool bounded = std::isfinite(row.minimum) && std::isfinite(row.maximum);
    if (bounded) {
        double position = position_of(row, value);
        constexpr double first = 0, last = 1;
        ImGui::SetNextItemWidth(std::max(ImGui::GetFontSize(), c.slider_width - taken));
        const bool typing_wanted = ImGui::GetIO().KeyCtrl;
        const bool moved = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &position, &first, &last, "",
                                               ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
        remember_item(context.items, key);
        if (ImGui::IsItemClicked() && typing_wanted)
            focus_ = key;
        else if (moved && focus_ != key) {
            value = std::clamp(rounded(row, value_at(row, position)), row.minimum, row.maximum);
            changed = true;
        }
        ImGui::SameLine(c.typed);
    }
    return draw_typed(context, row, key, value) || changed;
}

bool ParameterPanel::draw_typed(const PanelContext& context, const ParameterRow& row, const std::string& key,
                                double& value) {
    const Columns c = columns();
    const bool typing = typing_ == key;
    double shown = typing ? typed_value_ : value;
    const bool outside = !(shown >= row.minimum && shown <= row.maximum);
    if (focus_ == key && !ImGui::IsMouseDown(0)) {
        ImGui::SetKeyboardFocusHere();
        focus_.clear();
    }
    if (outside) ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(context.theme.bad));
    ImGui::SetNextItemWidth(c.typed_width);
    const bool edited =
        ImGui::InputScalar("##typed", ImGuiDataType_Double, &shown, nullptr, nullptr, "%.6g",
                           ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_AutoSelectAll);
    if (outside) ImGui::PopStyleColor();
    remember_item(context.items, key + ".input");
    if (edited) typing_ = key, typed_value_ = shown;
    if (typing_ != key || ImGui::IsItemActive()) return false;
    typing_.clear();
    if (!std::isfinite(typed_value_)) return false;
    const double taken = std::clamp(typed_value_, row.minimum, row.maximum);
    const bool changed = taken != value;
    value = taken;
    return changed;
}

} // namespace gaspard
