#include "core/tessellate/line_section.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/number_text.hpp"
#include "core/base/parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace gaspard {

namespace {

/// The part of the line in one triangle: from and to, as parts of the length, and the values there.
struct LinePiece {
    double from, to, first, last;
    std::uint32_t cell;
    double at(double t) const {
        return to > from ? first + (last - first) * ((t - from) / (to - from)) : first;
    }
};

double cross_xy(Vec3 a, Vec3 b) { return a.x * b.y - a.y * b.x; }

/// The part of the line a + t d, 0 <= t <= 1, in a triangle; nothing if it is a point or none.
std::optional<std::pair<double, double>> part_in_triangle(Vec3 a, Vec3 d,
                                                          const std::array<Vec3, 3>& corners) {
    double low = 0, high = 1;
    const double area = cross_xy(corners[1] - corners[0], corners[2] - corners[0]);
    if (area == 0) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) { // inside each side: offset + t rate >= 0
        const Vec3 side = corners[(k + 1) % 3] - corners[k];
        const double sign = area > 0 ? 1 : -1;
        const double offset = sign * cross_xy(side, a - corners[k]), rate = sign * cross_xy(side, d);
        const double rounding = 1e-14 * norm(side) * (norm(a - corners[k]) + norm(d));
        if (std::abs(rate) <= rounding) {
            if (offset < -rounding) return std::nullopt;
        } else if (rate > 0) {
            low = std::max(low, -offset / rate);
        } else {
            high = std::min(high, -offset / rate);
        }
    }
    if (!(high - low > 1e-12)) return std::nullopt;
    return std::pair(low, high);
}

/// The weights of the corners at a point.
std::array<double, 3> barycentric(const std::array<Vec3, 3>& corners, Vec3 p) {
    const double area = cross_xy(corners[1] - corners[0], corners[2] - corners[0]);
    const double second = cross_xy(p - corners[0], corners[2] - corners[0]) / area,
                 third = cross_xy(corners[1] - corners[0], p - corners[0]) / area;
    return {1 - second - third, second, third};
}

std::vector<LinePiece> pieces_of_line(const Tessellation& shape, const Points& shown,
                                      const Colouring& colouring, const SectionLine& line) {
    const bool nodal = colouring.place == FieldPlace::node;
    const std::vector<double> values = nodal ? shown_values(shape, colouring.values) : std::vector<double>();
    const Vec3 d = line.to - line.from;
    std::vector<double> beside(shape.point_count); // the line, with sign
    for (std::size_t i = 0; i < beside.size(); ++i) beside[i] = cross_xy(d, shown[i] - line.from);
    std::vector<LinePiece> pieces;
    for (std::size_t t = 0; t < shape.triangle_cells.size(); ++t) {
        const std::array<std::uint32_t, 3> points = {shape.triangles[3 * t], shape.triangles[3 * t + 1],
                                                     shape.triangles[3 * t + 2]};
        const double one = beside[points[0]], two = beside[points[1]], three = beside[points[2]];
        if ((one > 0 && two > 0 && three > 0) || (one < 0 && two < 0 && three < 0)) continue;
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = {shown[points[k]].x, shown[points[k]].y, 0};
        const auto part = part_in_triangle(line.from, d, corners);
        if (!part) continue;
        const std::uint32_t cell = shape.triangle_cells[t];
        const auto value = [&](double at) {
            if (!nodal) return colouring.values[cell];
            const auto weights = barycentric(corners, line.from + at * d);
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * values[points[k]];
            return sum;
        };
        pieces.push_back({part->first, part->second, value(part->first), value(part->second), cell});
    }
    std::ranges::sort(pieces, [](const LinePiece& a, const LinePiece& b) {
        return std::tuple(a.from, a.to, a.cell) < std::tuple(b.from, b.to, b.cell);
    });
    return pieces;
}

} // namespace

std::optional<SectionLine> parse_section_line(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view word : split(text, " ")) {
        if (word.empty()) continue;
        const auto number = parse_number(word);
        if (!number) numbers.resize(5); // refused below
        if (number) numbers.push_back(*number);
    }
    if (numbers.empty()) return std::nullopt;
    const bool overflows =
        numbers.size() == 4 && !std::isfinite(std::hypot(numbers[2] - numbers[0], numbers[3] - numbers[1]));
    if (numbers.size() != 4 || overflows || (numbers[0] == numbers[2] && numbers[1] == numbers[3]))
        throw InputError(
            "view.section = '" + std::string(text) +
            "' is not a line between two different points: 'x0 y0 x1 y1', such as '0 0.5 1 0.5'");
    return SectionLine{{numbers[0], numbers[1], 0}, {numbers[2], numbers[3], 0}};
}

std::string format_section_line(const SectionLine& line) {
    return format_number(line.from.x) + " " + format_number(line.from.y) + " " + format_number(line.to.x) +
           " " + format_number(line.to.y);
}

bool has_section_line(const Mesh& mesh) {
    return mesh.space_dimension == 2 && cell_dimension(mesh.kind) == 2;
}

ValuesOnLine values_on_line(const Tessellation& shape, const Points& shown, const Colouring& colouring,
                            const SectionLine& line) {
    ValuesOnLine found;
    const double length = line.length();
    const auto add = [&](double t, double value, std::uint32_t cell) {
        found.arc.push_back(t * length);
        found.values.push_back(value);
        found.cells.push_back(cell);
    };
    constexpr double slack = 1e-9; // of the length: gaps and overlaps by rounding
    double end = 0;
    for (const LinePiece& piece : pieces_of_line(shape, shown, colouring, line)) {
        if (piece.to <= end + 1e-12) continue; // along a side, or hidden
        const bool first = found.cells.empty();
        const double from = std::max(piece.from, end);
        if (!first && piece.from > end + slack)
            add((end + piece.from) / 2, std::numeric_limits<double>::quiet_NaN(), ValuesOnLine::no_cell);
        else if (!first && piece.cell != found.cells.back())
            found.sides.push_back(from * length);
        add(from, piece.at(from), piece.cell);
        add(piece.to, piece.last, piece.cell);
        end = piece.to;
    }
    return found;
}

ValuesOnLine values_on_line(const Snapshot& snapshot, const Colouring& colouring, const SectionLine& line) {
    const Tessellation shape = tessellate(*snapshot.mesh, cuts_for(*snapshot.mesh, snapshot.x));
    return values_on_line(shape, shown_points(shape, snapshot.x), colouring, line);
}

Plot section_line_plot(const ValuesOnLine& values, const Colouring& colouring) {
    const std::string name =
        colouring.label + (colouring.symbol.empty() ? std::string() : " " + colouring.symbol);
    Plot plot{.title = "", .x = {.label = "arc length"}, .y = {.label = name}, .curves = {}};
    plot.curves.push_back({.label = "", .x = values.arc, .y = values.values, .name = name});
    plot.rows.push_back({values.sides, 0});
    return plot;
}

std::string section_line_csv(const ValuesOnLine& values, const Colouring& colouring,
                             const SectionLine& line) {
    std::string text = "arc_length,x,y," + colouring.name + ",cell\n";
    const Vec3 direction = (1 / line.length()) * (line.to - line.from);
    for (std::size_t i = 0; i < values.arc.size(); ++i) {
        if (values.cells[i] == ValuesOnLine::no_cell) {
            text += '\n';
            continue;
        }
        const Vec3 p = line.from + values.arc[i] * direction;
        for (const double number : {values.arc[i], p.x, p.y, values.values[i]})
            text += format_number(number) + ',';
        text += std::to_string(values.cells[i]) + '\n';
    }
    return text;
}

} // namespace gaspard
