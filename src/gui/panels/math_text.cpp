#include "gui/panels/math_text.hpp"

#include "core/base/superscript.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace gaspard {

namespace {

using Kind = MathNode::Kind;
using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array<Pair, 14> greek{{{"alpha", "α"},
                                      {"beta", "β"},
                                      {"gamma", "γ"},
                                      {"delta", "δ"},
                                      {"epsilon", "ε"},
                                      {"eps", "ε"},
                                      {"theta", "θ"},
                                      {"lambda", "λ"},
                                      {"mu", "μ"},
                                      {"pi", "π"},
                                      {"rho", "ρ"},
                                      {"sigma", "σ"},
                                      {"phi", "φ"},
                                      {"omega", "ω"}}};

/// The length of the character that begins here, in bytes.
std::size_t length_of(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    return std::min<std::size_t>(first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4, text.size());
}

/// Letters that fonts lack.
constexpr std::array<Pair, 3> subscripts{{{"ᵢ", "i"}, {"ₖ", "k"}, {"ₘ", "m"}}};

std::string greek_name(std::string_view name) {
    for (const auto& [from, to] : greek)
        if (name == from) return std::string(to);
    return std::string(name);
}

MathNode text_node(std::string text) { return {Kind::text, std::move(text), {}}; }
MathNode row_of(std::vector<MathNode> parts) {
    return parts.size() == 1 ? std::move(parts.front()) : MathNode{Kind::row, {}, std::move(parts)};
}

/// Fails by an empty optional: the text is then shown as it is.
class MathParser {
  public:
    explicit MathParser(std::string_view text) : rest_(text) {}

    std::optional<MathNode> parse() {
        auto whole = relations();
        skip();
        return rest_.empty() && !failed_ ? std::optional(std::move(whole)) : std::nullopt;
    }

  private:
    bool skip() {
        bool space = false;
        while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1), space = true;
        return space;
    }
    bool at(std::string_view sign) const { return rest_.starts_with(sign); }
    bool take(std::string_view sign) {
        skip();
        if (!at(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }
    MathNode fail() {
        failed_ = true;
        return {};
    }

    MathNode relations() {
        std::vector<MathNode> parts{sum()};
        for (;;) {
            if (take("="))
                parts.push_back(text_node(" = "));
            else if (take("≤"))
                parts.push_back(text_node(" ≤ "));
            else if (take(","))
                parts.push_back(text_node(", "));
            else
                return row_of(std::move(parts));
            parts.push_back(sum());
            if (failed_) return {};
        }
    }

    MathNode sum() {
        std::vector<MathNode> parts;
        if (take("-") || take("−")) parts.push_back(text_node("−"));
        if (take("±")) parts.push_back(text_node("±"));
        parts.push_back(product());
        for (;;) {
            skip();
            if (failed_) return {};
            if (take("+"))
                parts.push_back(text_node(" + "));
            else if (take("-") || take("−"))
                parts.push_back(text_node(" − "));
            else
                return row_of(std::move(parts));
            parts.push_back(product());
        }
    }

    bool begins_factor() const {
        if (rest_.empty()) return false;
        const auto c = static_cast<unsigned char>(rest_.front());
        if (std::isalnum(c) || c == '(' || (c == '|' && bars_ == 0)) return true;
        return c >= 0x80 && superscript(rest_).first == 0 && !at("−") && !at("·") && !at("≤") && !at("±");
    }

    MathNode product() {
        std::vector<MathNode> factors{power()};
        while (!failed_) {
            skip();
            if (take("/")) {
                MathNode over = without_brackets(std::move(factors.back())),
                         under = without_brackets(power());
                factors.back() = {Kind::fraction, {}, {std::move(over), std::move(under)}};
                continue;
            }
            const bool times = take("*") || take("·");
            if (!times && !begins_factor()) break;
            const bool numbers = times && ends_with_digit(factors.back()) && !rest_.empty() &&
                                 std::isdigit(static_cast<unsigned char>(rest_.front()));
            factors.push_back(text_node(numbers ? " · " : " "));
            factors.push_back(power());
        }
        return row_of(std::move(factors));
    }
    static bool ends_with_digit(const MathNode& node) {
        return node.kind == Kind::text && !node.text.empty() &&
               std::isdigit(static_cast<unsigned char>(node.text.back()));
    }
    static MathNode without_brackets(MathNode node) {
        if (node.kind == Kind::group && node.text == "()") return std::move(node.parts.front());
        return node;
    }

    /// A factor with its powers; a function with a power takes its argument after that: "sech²(...)".
    MathNode power() {
        skip();
        bool name = false;
        MathNode base = primary(name);
        for (;;) {
            if (failed_ || rest_.empty()) return base;
            std::string exponent;
            while (!rest_.empty()) {
                const auto [length, raised] = superscript(rest_);
                if (length == 0) break;
                exponent += raised;
                rest_.remove_prefix(length);
            }
            const bool adjacent = at("("); // else a product: "B (x)"
            if (!exponent.empty()) {
                base = {Kind::power, {}, {std::move(base), text_node(exponent)}};
            } else if (take("^")) {
                const bool minus = take("-") || take("−");
                if (++depth_ > deepest) return fail();
                MathNode raised = without_brackets(power()); // of the right: x^y^z is x^(y^z)
                --depth_;
                if (minus) raised = row_of({text_node("−"), std::move(raised)});
                base = {Kind::power, {}, {std::move(base), std::move(raised)}};
                name = false;
            } else if (name && adjacent) {
                bool unused = false;
                base = row_of({std::move(base), primary(unused)});
                name = false;
            } else {
                return base;
            }
        }
    }

    MathNode group(std::string_view close, std::string signs) {
        MathNode inside = relations();
        if (failed_ || !take(close)) return fail();
        return {Kind::group, std::move(signs), {std::move(inside)}};
    }

    MathNode primary(bool& name) {
        skip();
        if (rest_.empty() || ++depth_ > deepest) return fail();
        struct Leave {
            int& depth;
            ~Leave() { --depth; }
        } leave{depth_};
        if (take("(")) {
            const int bars = std::exchange(bars_, 0);
            MathNode node = group(")", "()");
            bars_ = bars;
            return node;
        }
        if (take("|")) {
            ++bars_;
            MathNode node = group("|", "||");
            --bars_;
            return node;
        }
        const auto first = static_cast<unsigned char>(rest_.front());
        if (std::isdigit(first) || first == '.') return number();
        if (std::isalpha(first) || first >= 0x80 || first == '_') return identifier(name);
        return fail();
    }

    MathNode number() {
        std::size_t n = 0;
        const auto digit = [&](std::size_t i) {
            return i < rest_.size() &&
                   (std::isdigit(static_cast<unsigned char>(rest_[i])) || rest_[i] == '.');
        };
        while (digit(n)) ++n;
        std::string mantissa(rest_.substr(0, n));
        const bool exponent = n < rest_.size() && (rest_[n] == 'e' || rest_[n] == 'E') &&
                              (digit(n + 1) || (n + 2 < rest_.size() && digit(n + 2) &&
                                                (rest_[n + 1] == '-' || rest_[n + 1] == '+')));
        if (!exponent) {
            rest_.remove_prefix(n);
            return text_node(std::move(mantissa));
        }
        std::size_t m = n + 1;
        std::string power;
        if (rest_[m] == '-') power = "−";
        if (rest_[m] == '-' || rest_[m] == '+') ++m;
        while (digit(m)) power += rest_[m++];
        rest_.remove_prefix(m);
        MathNode ten{Kind::power, {}, {text_node("10"), text_node(std::move(power))}};
        MathNode whole = mantissa == "1" ? ten : row_of({text_node(mantissa + " · "), std::move(ten)});
        skip();
        if (!at("^")) return whole;
        return {Kind::group, "()", {std::move(whole)}}; // 2e3^2 is (2 · 10³)²
    }

    MathNode identifier(bool& name) {
        std::size_t n = 0;
        while (n < rest_.size()) {
            const std::string_view one = rest_.substr(n, length_of(rest_.substr(n)));
            const auto c = static_cast<unsigned char>(one.front());
            const bool letter = c >= 0x80 ? superscript(one).first == 0 && one != "−" && one != "·" &&
                                                one != "≤" && one != "±"
                                          : std::isalnum(c) || c == '_' || c == '\'';
            if (!letter) break;
            n += one.size();
        }
        const std::string whole(rest_.substr(0, n));
        rest_.remove_prefix(n);
        if (whole == "sqrt" && at("(")) {
            rest_.remove_prefix(1);
            MathNode inside = relations();
            if (failed_ || !take(")")) return fail();
            return {Kind::root, {}, {std::move(inside)}};
        }
        name = true;
        for (const auto& [letter, index] : subscripts)
            if (whole.size() > letter.size() && whole.ends_with(letter))
                return {Kind::index,
                        {},
                        {text_node(whole.substr(0, whole.size() - letter.size())),
                         text_node(std::string(index))}};
        const std::size_t mark = whole.find('_');
        if (mark == std::string::npos || mark == 0 || mark + 1 == whole.size())
            return text_node(greek_name(whole));
        return {
            Kind::index,
            {},
            {text_node(greek_name(whole.substr(0, mark))), text_node(greek_name(whole.substr(mark + 1)))}};
    }

    static constexpr int deepest = 60;
    std::string_view rest_;
    int bars_ = 0, depth_ = 0;
    bool failed_ = false;
};

constexpr float smaller = 0.72F; // of exponents and indices

MathSize text_extent(const std::string& text, float size) {
    const ImVec2 extent =
        ImGui::GetFont()->CalcTextSizeA(size, 1e9F, 0, text.data(), text.data() + text.size());
    return {extent.x, 0.8F * size, 0.25F * size};
}

/// Around a content of one line, brackets are letters.
bool is_low(const MathSize& inside, float size) { return inside.height() < 1.2F * size; }

/// Of the signs around a group.
float bracket_width(const MathSize& inside, float size) {
    if (is_low(inside, size)) return text_extent("(", size).width;
    return std::clamp(0.3F * inside.height(), 0.3F * size, 0.5F * size);
}

float raise_of(const MathSize& base, const MathSize& exponent, float size) {
    return std::max(0.38F * size, base.ascent - 0.45F * exponent.ascent);
}

} // namespace

std::optional<MathNode> parse_math(std::string_view text) {
    constexpr std::size_t longest = 400; // bytes; a longer one fits nowhere
    return text.size() > longest ? std::nullopt : MathParser(text).parse();
}

MathSize math_size(const MathNode& node, float size) {
    MathSize whole;
    switch (node.kind) {
    case Kind::text:
        return text_extent(node.text, size);
    case Kind::row:
        for (const MathNode& part : node.parts) {
            const MathSize one = math_size(part, size);
            whole.width += one.width;
            whole.ascent = std::max(whole.ascent, one.ascent);
            whole.descent = std::max(whole.descent, one.descent);
        }
        return whole;
    case Kind::fraction: {
        const MathSize over = math_size(node.parts[0], 0.9F * size),
                       under = math_size(node.parts[1], 0.9F * size);
        const float axis = 0.28F * size, gap = 0.14F * size;
        return {std::max(over.width, under.width) + 0.35F * size, over.height() + gap + axis,
                under.height() + gap - axis};
    }
    case Kind::power:
    case Kind::index: {
        const MathSize base = math_size(node.parts[0], size), mark = math_size(node.parts[1], smaller * size);
        if (node.kind == Kind::index)
            return {base.width + mark.width, base.ascent, std::max(base.descent, 0.2F * size + mark.descent)};
        const float raise = raise_of(base, mark, size);
        return {base.width + mark.width, std::max(base.ascent, raise + mark.ascent), base.descent};
    }
    case Kind::root: {
        const MathSize inside = math_size(node.parts[0], size);
        return {inside.width + 0.75F * size, inside.ascent + 0.16F * size, inside.descent};
    }
    case Kind::group: {
        const MathSize inside = math_size(node.parts[0], size);
        return {inside.width + 2 * bracket_width(inside, size), inside.ascent, inside.descent};
    }
    }
    return whole;
}

namespace {

void draw_bracket(ImDrawList& list, const std::string& signs, bool opens, ImVec2 low, ImVec2 high, float size,
                  ImU32 colour) {
    const float thickness = std::max(1.0F, 0.075F * size);
    if (high.y - low.y < 1.2F * size && signs != "||")
        return list.AddText(ImGui::GetFont(), size, {low.x, low.y}, colour, opens ? "(" : ")");
    if (signs == "||") {
        const float x = (low.x + high.x) / 2;
        return list.AddLine({x, low.y}, {x, high.y}, colour, thickness);
    }
    const float outer = opens ? low.x + 0.1F * size : high.x - 0.1F * size;
    const float inner = opens ? high.x - 0.02F * size : low.x + 0.02F * size;
    const float bend = outer - 0.25F * (inner - outer), third = (high.y - low.y) / 3;
    list.AddBezierCubic({inner, low.y}, {bend, low.y + third}, {bend, high.y - third}, {inner, high.y},
                        colour, thickness);
}

/// With the baseline at `y`.
void draw_at(ImDrawList& list, const MathNode& node, float x, float y, float size, ImU32 colour) {
    const float thickness = std::max(1.0F, 0.075F * size);
    switch (node.kind) {
    case Kind::text:
        return list.AddText(ImGui::GetFont(), size, {x, y - 0.8F * size}, colour, node.text.data(),
                            node.text.data() + node.text.size());
    case Kind::row:
        for (const MathNode& part : node.parts) {
            draw_at(list, part, x, y, size, colour);
            x += math_size(part, size).width;
        }
        return;
    case Kind::fraction: {
        const MathSize whole = math_size(node, size), over = math_size(node.parts[0], 0.9F * size),
                       under = math_size(node.parts[1], 0.9F * size);
        const float axis = y - 0.28F * size, gap = 0.14F * size;
        list.AddLine({x + 0.06F * size, axis}, {x + whole.width - 0.06F * size, axis}, colour, thickness);
        draw_at(list, node.parts[0], x + (whole.width - over.width) / 2, axis - gap - over.descent,
                0.9F * size, colour);
        draw_at(list, node.parts[1], x + (whole.width - under.width) / 2, axis + gap + under.ascent,
                0.9F * size, colour);
        return;
    }
    case Kind::power:
    case Kind::index: {
        const MathSize base = math_size(node.parts[0], size), mark = math_size(node.parts[1], smaller * size);
        const float shift = node.kind == Kind::index ? 0.2F * size : -raise_of(base, mark, size);
        draw_at(list, node.parts[0], x, y, size, colour);
        return draw_at(list, node.parts[1], x + base.width, y + shift, smaller * size, colour);
    }
    case Kind::root: {
        const MathSize inside = math_size(node.parts[0], size);
        const float top = y - inside.ascent - 0.08F * size, bottom = y + inside.descent,
                    left = x + 0.6F * size;
        const std::array<ImVec2, 5> sign{{{x + 0.08F * size, y - 0.25F * size},
                                          {x + 0.22F * size, y - 0.33F * size},
                                          {x + 0.38F * size, bottom},
                                          {left, top},
                                          {left + inside.width + 0.1F * size, top}}};
        list.AddPolyline(sign.data(), static_cast<int>(sign.size()), colour, 0, thickness);
        return draw_at(list, node.parts[0], left + 0.05F * size, y, size, colour);
    }
    case Kind::group: {
        const MathSize inside = math_size(node.parts[0], size);
        const float width = bracket_width(inside, size), top = y - inside.ascent, bottom = y + inside.descent;
        draw_bracket(list, node.text, true, {x, top}, {x + width, bottom}, size, colour);
        draw_at(list, node.parts[0], x + width, y, size, colour);
        x += width + inside.width;
        return draw_bracket(list, node.text, false, {x, top}, {x + width, bottom}, size, colour);
    }
    }
}

/// The parts between which a line may be broken.
void add_breakable(const MathNode& node, std::vector<MathNode>& parts) {
    if (node.kind != Kind::row) return parts.push_back(node);
    for (const MathNode& part : node.parts) {
        const bool sum = part.kind == Kind::row &&
                         std::any_of(part.parts.begin(), part.parts.end(), [](const MathNode& one) {
                             return one.text == " + " || one.text == " − ";
                         });
        if (sum)
            add_breakable(part, parts);
        else
            parts.push_back(part);
    }
}

} // namespace

void draw_math(ImDrawList& list, const MathNode& node, ImVec2 corner, float size, Colour colour) {
    draw_at(list, node, corner.x, corner.y + math_size(node, size).ascent, size, packed(colour));
}

std::vector<MathNode> math_lines(const MathNode& node, float size, float width) {
    std::vector<MathNode> parts, lines;
    add_breakable(node, parts);
    std::vector<MathNode> line;
    float used = 0;
    const auto is_sign = [](const MathNode& part) {
        return part.text == " + " || part.text == " − " || part.text == " = ";
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        float needed = math_size(parts[i], size).width;
        if (is_sign(parts[i]) && i + 1 < parts.size()) needed += math_size(parts[i + 1], size).width;
        if (i > 0 && parts[i - 1].text == ", ") // a relation of its own stays together where it can
            for (std::size_t k = i + 1; k < parts.size() && parts[k].text != ", "; ++k)
                needed += math_size(parts[k], size).width;
        if (!line.empty() && used + needed > width && parts[i].text != ", " &&
            !(i > 0 && is_sign(parts[i - 1]))) {
            lines.push_back(row_of(std::exchange(line, {})));
            used = 0;
        }
        used += math_size(parts[i], size).width;
        line.push_back(parts[i]);
    }
    if (!line.empty()) lines.push_back(row_of(std::move(line)));
    return lines;
}

} // namespace gaspard
