#include "gui/panels/equation_box.hpp"

#include "core/base/join.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/panels/math_text.hpp"

#include <algorithm>
#include <imgui.h>
#include <vector>

namespace gaspard {

namespace {

bool is_number(const ParameterRow& row) {
    return row.kind == ParameterKind::real || row.kind == ParameterKind::integer;
}

std::string number_of(const Values& values, const ParameterRow& row) {
    return short_number(row.kind == ParameterKind::integer ? static_cast<double>(values.integer(row.key))
                                                           : values.real(row.key),
                        6);
}

/// An equation in lines; none if it is a sentence, or too wide.
struct Typeset {
    std::vector<MathNode> lines;
    float size = 0;
};

/// On one line, somewhat smaller if need be, else on several.
Typeset typeset(const std::string& equation, float em, float width) {
    const auto parsed = parse_math(equation);
    if (!parsed) return {};
    for (const float size : {1.02F * em, 0.92F * em, 0.84F * em})
        if (math_size(*parsed, size).width <= width) return {{*parsed}, size};
    for (const float size : {0.95F * em, 0.82F * em, 0.72F * em}) {
        std::vector<MathNode> lines = math_lines(*parsed, size, width);
        if (std::all_of(lines.begin(), lines.end(),
                        [&](const MathNode& line) { return math_size(line, size).width <= width; }))
            return {std::move(lines), size};
    }
    return {};
}

/// "c" of "c₁": without the subscript.
std::string without_index(std::string symbol) {
    for (const std::string_view index : {"₁", "₂", "₃", "ₓ"})
        if (symbol.ends_with(index)) symbol.resize(symbol.size() - index.size());
    return symbol;
}

} // namespace

std::string values_by_symbol(const Values& values) {
    std::string text;
    const auto add = [&text](const std::string& symbol, const std::string& value) {
        text += (text.empty() ? "" : "   ") + symbol + " = " + value;
    };
    const auto& rows = values.rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!is_number(rows[i]) || rows[i].symbol.empty()) continue;
        if (rows[i].point.empty()) {
            add(rows[i].symbol, number_of(values, rows[i]));
            continue;
        }
        const bool begun = i > 0 && rows[i - 1].point == rows[i].point;
        if (begun) continue;
        if (i + 1 == rows.size() || rows[i + 1].point != rows[i].point) {
            add(rows[i].symbol, number_of(values, rows[i])); // one coordinate
            continue;
        }
        std::string point = "(" + number_of(values, rows[i]);
        for (std::size_t k = i + 1; k < rows.size() && rows[k].point == rows[i].point; ++k)
            point += ", " + number_of(values, rows[k]);
        add(without_index(rows[i].symbol), point + ")");
    }
    return text;
}

std::string values_at_time(const Values& values, double t) {
    const auto& rows = values.rows();
    const bool named = std::ranges::any_of(
        rows, [](const ParameterRow& row) { return row.role == ParameterRole::time && row.symbol == "t"; });
    const std::string others = values_by_symbol(values);
    if (named) return others;
    return "t = " + short_number(t, 6) + (others.empty() ? "" : "   " + others);
}

/// The lines of values_by_symbol(), broken between two of them.
static std::vector<std::string> value_lines(const std::string& values, float width) {
    std::vector<std::string> lines;
    for (const std::string_view one : split(values, "   ")) {
        const std::string longer = lines.empty() ? "" : lines.back() + "   " + std::string(one);
        if (!lines.empty() && ImGui::CalcTextSize(longer.c_str()).x <= width)
            lines.back() = longer;
        else if (!one.empty())
            lines.emplace_back(one);
    }
    return lines;
}

void draw_equation_box(const std::string& equation, const std::string& values, float width,
                       const Theme& theme, bool or_text) {
    if (equation.empty()) return;
    const float em = ImGui::GetFontSize(), pad = 0.6F * em, inside = width - 2 * pad;
    const Typeset set = typeset(equation, em, inside);
    const std::vector<MathNode>& lines = set.lines;
    const float size = set.size;
    const bool fits = !lines.empty();
    if (!fits && !or_text) return;
    float height = 2 * pad;
    for (const MathNode& line : lines) height += math_size(line, size).height() + 0.25F * em;
    const auto wrapped = [&](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str(), nullptr, false, inside).y;
    };
    if (!fits) height = 2 * pad + wrapped(equation);
    const std::vector<std::string> numbers = value_lines(values, inside);
    if (!numbers.empty()) height += (static_cast<float>(numbers.size()) + 0.3F) * ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + width, corner.y + height}, packed(theme.frame, 0.55F),
                       ImGui::GetStyle().FrameRounding);
    float y = corner.y + pad;
    const auto write = [&](const std::string& text, Colour colour) {
        list.AddText(ImGui::GetFont(), em, {corner.x + pad, y}, packed(colour), text.c_str(), nullptr,
                     inside);
        y += wrapped(text);
    };
    if (fits)
        for (const MathNode& line : lines) {
            const MathSize one = math_size(line, size);
            draw_math(list, line, {corner.x + std::max(pad, (width - one.width) / 2), y}, size, theme.text);
            y += one.height() + 0.25F * em;
        }
    else
        write(equation, theme.text);
    y += 0.3F * em;
    for (const std::string& one : numbers) write(one, theme.faint_text);
    ImGui::Dummy({width, height});
}

} // namespace gaspard
