// A line across a mesh in the plane, and the values along it.
//
//   p(s) = a + s (b - a) / |b - a|,   0 <= s <= |b - a|      (s: arc length)
//
// The values are those that the colours show: linear in each triangle of the tessellation for fields of
// nodes, constant in each cell for fields of cells. Where cells overlap, the one that begins first is shown.
#pragma once

#include "core/tessellate/colouring.hpp"
#include "core/tessellate/plot.hpp"
#include "core/tessellate/tessellation.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct SectionLine {
    Vec3 from, to; ///< z = 0
    double length() const { return norm(to - from); }
    friend bool operator==(const SectionLine&, const SectionLine&) = default;
};

/// view.section: "x0 y0 x1 y1"; empty: nothing. Throws InputError.
std::optional<SectionLine> parse_section_line(std::string_view text);
std::string format_section_line(const SectionLine& line);

/// Whether a line can cut the mesh: its cells are surfaces in the plane.
bool has_section_line(const Mesh& mesh);

struct ValuesOnLine {
    static constexpr std::uint32_t no_cell = std::numeric_limits<std::uint32_t>::max();
    std::vector<double> arc, values;  ///< arc never decreases; a value that is not a number is a gap
    std::vector<std::uint32_t> cells; ///< in which the values are; no_cell in a gap
    std::vector<double> sides;        ///< where the line passes from a cell to the next, ascending
};

/// `shown`: where the points of the tessellation are.
ValuesOnLine values_on_line(const Tessellation& shape, const Points& shown, const Colouring& colouring,
                            const SectionLine& line);
/// Of the adapted mesh; makes a tessellation.
ValuesOnLine values_on_line(const Snapshot& snapshot, const Colouring& colouring, const SectionLine& line);

/// The sides of cells are a row below the curve.
Plot section_line_plot(const ValuesOnLine& values, const Colouring& colouring);
/// Columns arc_length, x, y, the name of the field, cell; a gap is an empty line.
std::string section_line_csv(const ValuesOnLine& values, const Colouring& colouring, const SectionLine& line);

} // namespace gaspard
