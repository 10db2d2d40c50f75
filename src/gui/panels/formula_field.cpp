#include "gui/panels/formula_field.hpp"

#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr double quiet = 0.3; // seconds after a key before a complaint appears: most formulas are half typed

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }

bool in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80U;
}

/// The byte at which a letter begins, counted from 1; the end of the text if it has fewer.
std::size_t byte_of(std::string_view text, std::size_t character) {
    std::size_t letters = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (begins_letter(text[i]) && ++letters == character) return i;
    return text.size();
}

float line_width() { return ImGui::GetContentRegionAvail().x; }

} // namespace

std::string broken_at_blanks(std::string formula, std::size_t columns) {
    std::size_t start = 0, blank = std::string::npos, letters = 0;
    for (std::size_t i = 0; i < formula.size(); ++i) {
        if (formula[i] == '\n') {
            start = i + 1, blank = std::string::npos, letters = 0;
            continue;
        }
        if (formula[i] == ' ') blank = i;
        if (begins_letter(formula[i])) ++letters;
        if (letters <= columns || blank == std::string::npos || blank <= start) continue;
        formula[blank] = '\n';
        start = blank + 1;
        letters = static_cast<std::size_t>(std::count_if(formula.begin() + static_cast<std::ptrdiff_t>(start),
                                                         formula.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                                         begins_letter));
        blank = std::string::npos;
    }
    return formula;
}

std::string in_one_line(std::string formula) {
    for (char& c : formula)
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    return formula;
}

std::string inserted_text(const FormulaWord& word) {
    return word.function ? word.text.substr(0, word.text.find('(') + 1) : word.text;
}

FormulaExcerpt excerpt_at(std::string_view formula, std::size_t character, std::size_t around) {
    const std::size_t begin = byte_of(formula, character);
    std::size_t end = begin;
    if (end < formula.size() && in_name(formula[end]))
        while (end < formula.size() && in_name(formula[end])) ++end;
    else if (end < formula.size())
        ++end;
    const auto before = [&] {
        std::size_t from = begin, left = around;
        while (from > 0 && (left > 0 || !begins_letter(formula[from])))
            if (begins_letter(formula[--from])) --left;
        return std::string(from > 0 ? "..." : "") + std::string(formula.substr(from, begin - from));
    };
    const auto after = [&] {
        std::size_t to = end, left = around;
        while (to < formula.size() && (left > 0 || !begins_letter(formula[to])))
            if (begins_letter(formula[to++]) && left > 0) --left;
        return std::string(formula.substr(end, to - end)) + (to < formula.size() ? "..." : "");
    };
    return {before(), begin == formula.size() ? " " : std::string(formula.substr(begin, end - begin)),
            after()};
}

void FormulaField::refuse(const std::string& why) {
    const auto found = drafts_.find(last_applied_);
    if (found == drafts_.end() || found->second.unread) return; // it is being typed anew
    const std::string named = last_applied_ + ": ";
    found->second.complaint = FormulaComplaint{why.starts_with(named) ? why.substr(named.size()) : why, {}};
    found->second.refused = found->second.complained = true;
}

void FormulaField::restore(std::string_view key) {
    if (const auto found = drafts_.find(key); found != drafts_.end()) drafts_.erase(found);
}

void FormulaField::focus(const std::string& key) {
    cursors_[key].wanted = std::numeric_limits<int>::max();
    focus_.want(key);
}

bool FormulaField::waiting() const {
    const double now = ImGui::GetTime();
    return !insert_into_.empty() || focus_.pending() ||
           std::any_of(drafts_.begin(), drafts_.end(), [&](const auto& one) {
               return one.second.unread && now - one.second.typed_at < pause + 0.1;
           });
}

/// The field itself. True if Enter was pressed in it.
bool FormulaField::edit(const std::string& key, std::string& text, bool wrong, float width,
                        const Context& context) {
    Cursor& cursor = cursors_[key];
    if (insert_into_ == key) {
        const auto at =
            cursor.at < 0 ? text.size() : std::min(static_cast<std::size_t>(cursor.at), text.size());
        text.insert(at, inserted_);
        cursor.wanted = static_cast<int>(at + inserted_.size());
        insert_into_.clear();
        focus_.want(key);
    }
    ImGui::PushFont(formula_font());
    const auto lines =
        std::clamp<std::ptrdiff_t>(std::count(text.begin(), text.end(), '\n') + 1, context.least_lines, 8);
    const float height =
        static_cast<float>(lines) * ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().FramePadding.y;
    if (wrong) {
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
        ImGui::PushStyleColor(ImGuiCol_Border, to_imgui(context.theme.bad));
    }
    if (focus_.wanted(key)) focus_.ask();
    const auto follow = [](ImGuiInputTextCallbackData* data) {
        auto& at = *static_cast<Cursor*>(data->UserData);
        if (at.wanted)
            data->CursorPos = data->SelectionStart = data->SelectionEnd =
                std::min(*at.wanted, data->BufTextLen);
        at.wanted.reset();
        at.at = data->CursorPos;
        return 0;
    };
    const bool entered = ImGui::InputTextMultiline("##formula", &text, {width, height},
                                                   ImGuiInputTextFlags_EnterReturnsTrue |
                                                       ImGuiInputTextFlags_CtrlEnterForNewLine |
                                                       ImGuiInputTextFlags_CallbackAlways,
                                                   follow, &cursor);
    focus_.note(key, ImGui::IsItemActive());
    remember_item(context.items, key);
    if (wrong) ImGui::PopStyleColor(), ImGui::PopStyleVar();
    ImGui::PopFont();
    return entered;
}

std::optional<std::string> FormulaField::draw(const std::string& key, const std::string& value,
                                              const Context& context) {
    ImGui::PushFont(formula_font());
    const float letter = ImGui::CalcTextSize("0").x;
    ImGui::PopFont();
    const float width = context.width > 0 ? context.width : line_width();
    const float inside = width - 2 * ImGui::GetStyle().FramePadding.x;
    const auto columns = static_cast<std::size_t>(std::max(10.0F, inside / letter));
    const auto found = drafts_.find(key);
    const double now = ImGui::GetTime();
    std::string text = found == drafts_.end() ? broken_at_blanks(value, columns) : found->second.text;
    const std::string before = text;
    const bool wrong = found != drafts_.end() && found->second.complained;
    const bool entered = edit(key, text, wrong, width, context);
    const bool active = ImGui::IsItemActive();
    if (text != before) {
        Draft& draft = found == drafts_.end() ? drafts_[key] : found->second;
        if (found == drafts_.end()) draft.over = value;
        draft.text = text, draft.typed_at = now, draft.unread = true, draft.refused = draft.freed = false;
        draft.complaint = context.check(in_one_line(text)), draft.situation = context.situation;
    } else if (found != drafts_.end()) {
        check_again(found->second, entered, context);
    }
    std::optional<std::string> applied;
    if (const auto present = drafts_.find(key); present != drafts_.end()) {
        Draft& draft = present->second;
        const bool due = entered || !active || now - draft.typed_at >= pause;
        draft.complained =
            draft.complaint && (draft.complained || !draft.unread || due || now - draft.typed_at >= quiet);
        if (draft.unread && due) {
            draft.unread = false;
            const std::string formula = in_one_line(draft.text);
            if (!draft.complaint && formula != value) {
                draft.over = value;
                applied = draft.applied = formula;
                last_applied_ = key;
            }
        }
        draw_complaint(key, draft, context);
    }
    if (!applied) forget_if_done(key, value, active);
    return applied;
}

/// Other values may have made a wrong formula valid, or the reverse; Enter tries it in any case.
void FormulaField::check_again(Draft& draft, bool entered, const Context& context) {
    if (draft.unread) return;
    const bool waits = (draft.complaint || draft.freed) && !draft.refused;
    if (!entered && (!waits || draft.situation == context.situation)) return;
    draft.complaint = context.check(in_one_line(draft.text)), draft.situation = context.situation;
    draft.freed = !entered && !draft.complaint;
    if (entered) draft.unread = true, draft.refused = false;
}

/// A draft goes when its formula is the value, or when the value was changed elsewhere, as by undo.
void FormulaField::forget_if_done(const std::string& key, const std::string& value, bool active) {
    const auto found = drafts_.find(key);
    if (found == drafts_.end() || found->second.unread || active) return; // ImGui has a text of its own then
    const Draft& draft = found->second;
    const std::string formula = in_one_line(draft.text);
    const bool taken_back = value != formula && value == draft.over && !draft.applied.empty() &&
                            !draft.refused && !draft.freed && !draft.complaint;
    const bool elsewhere = value != formula && value != draft.over && value != draft.applied;
    if (taken_back || elsewhere || (value == formula && !draft.complaint)) drafts_.erase(found);
}

void FormulaField::draw_complaint(const std::string& key, const Draft& draft, const Context& context) const {
    if (draft.freed) {
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + line_width());
        ImGui::TextDisabled("Valid now, not applied yet: press Enter in the field to apply it.");
        ImGui::PopTextWrapPos();
        return remember_item(context.items, key + ".valid");
    }
    if (!draft.complained) return;
    const FormulaComplaint& complaint = *draft.complaint;
    ImGui::BeginGroup();
    if (complaint.character) {
        const std::string line = in_one_line(draft.text);
        const FormulaExcerpt part = excerpt_at(line, *complaint.character, 12);
        ImGui::PushFont(formula_font());
        ImGui::TextDisabled("%s", part.before.c_str());
        ImGui::SameLine(0, 0);
        ImGui::TextColored(to_imgui(context.theme.bad), "%s", part.place.c_str());
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddLine({from.x, to.y}, to, packed(context.theme.bad),
                                            std::max(1.0F, 0.1F * ImGui::GetFontSize()));
        ImGui::SameLine(0, 0);
        ImGui::TextDisabled("%s", part.after.c_str());
        ImGui::PopFont();
    }
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + line_width());
    ImGui::TextColored(to_imgui(context.theme.bad), "%s", complaint.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    remember_item(context.items, key + ".complaint");
}

void FormulaField::draw_help(const std::string& key, const Context& context) {
    const char* const list = "functions and variables";
    if (ImGui::SmallButton("?")) ImGui::OpenPopup(list);
    remember_item(context.items, key + ".help");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Functions and variables to insert");
    if (!ImGui::BeginPopup(list)) return;
    for (const bool functions : {false, true}) {
        ImGui::TextDisabled("%s", functions ? "Functions" : "Variables and constants");
        constexpr int columns = 3;
        if (!ImGui::BeginTable(functions ? "functions" : "variables", columns,
                               ImGuiTableFlags_SizingStretchSame, {30 * ImGui::GetFontSize(), 0}))
            continue;
        for (const FormulaWord& word : context.words) {
            if (word.function != functions) continue;
            ImGui::TableNextColumn();
            ImGui::PushFont(formula_font());
            const bool chosen = ImGui::Selectable(word.text.c_str());
            ImGui::PopFont();
            if (chosen) insert_into_ = key, inserted_ = inserted_text(word);
            remember_item(context.items, key + "+" + word.text);
            if (!word.help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", word.help.c_str());
        }
        ImGui::EndTable();
        ImGui::Spacing();
    }
    ImGui::EndPopup();
}

} // namespace gaspard
