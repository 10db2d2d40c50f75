// Formulas as people write them: fractions, powers, roots, Greek letters, from the one-line texts of
// equations and from typed formulas.
//
//   "m(x) = 1 + A / (1 + (B r)²)"    "1 + 10*exp(-50*((x - 0.5)^2 + y^2))"    "sqrt(alpha_1)"
//
// A sum, products by "*" or by a space, fractions by "/", powers by "^" or superscripts, |absolute values|
// and functions; relations and commas separate sums.
#pragma once

#include "gui/base/theme.hpp"

#include <imgui.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A part of a formula.
struct MathNode {
    enum class Kind { text, row, fraction, power, index, root, group };
    Kind kind = Kind::text;
    std::string text{};            ///< of texts; of groups the opening and the closing sign: "()", "||"
    std::vector<MathNode> parts{}; ///< numerator and denominator; base and exponent; base and index; content
};

/// Empty if the text is no such formula; it is then best shown as it is.
std::optional<MathNode> parse_math(std::string_view text);

/// The size of a formula in the current font; the baseline is `ascent` below its upper edge.
struct MathSize {
    float width = 0, ascent = 0, descent = 0;
    float height() const { return ascent + descent; }
};
MathSize math_size(const MathNode& node, float size);
/// With the upper left corner at a position.
void draw_math(ImDrawList& list, const MathNode& node, ImVec2 corner, float size, Colour colour);

/// The parts of a formula that fit into lines of this width, broken at relations, commas and signs of sums.
/// A part that is too wide has a line of its own.
std::vector<MathNode> math_lines(const MathNode& node, float size, float width);

} // namespace gaspard
