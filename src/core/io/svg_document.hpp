// The frame of an SVG image, and its text.
#pragma once

#include "core/io/svg_path.hpp"
#include "core/tessellate/background.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

constexpr double points_per_mm = 72 / 25.4;
constexpr double svg_font_size = 8; ///< points

/// "#0072b2"
std::string svg_colour(std::array<unsigned char, 3> colour);
/// White on paper; empty if there is none.
std::string svg_background(const Background& background);

/// A document of this size in points around `content`, on a background of this colour; on none if it is
/// empty. The page is larger by `zoom`, with all that is on it.
std::string svg_document(double width, double height, std::string_view title, std::string_view content,
                         std::string_view background = "#fff", double zoom = 1);

enum class Anchor { start, middle, end };

/// One line of text, its baseline at `at`. Superscript digits become raised digits, which every font has.
std::string svg_text(PagePoint at, Anchor anchor, std::string_view text, std::string_view attributes = {});
/// About how wide that is, in points.
double svg_text_width(std::string_view text);
/// Parts of a text, so many to a line as fit.
std::vector<std::string> svg_lines(const std::vector<std::string>& parts, double width);

/// A path with these attributes, which begin with a space; nothing if it is empty.
std::string path_element(const SvgPath& path, const std::string& attributes = {});

} // namespace gaspard
