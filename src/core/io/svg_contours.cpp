#include "core/io/svg_contours.hpp"

#include "core/tessellate/contours.hpp"
#include "core/tessellate/tessellation.hpp"

#include <map>
#include <tuple>

namespace gaspard {

SvgContours svg_contours(const Snapshot& snapshot, const Colouring& colouring, const Points& x) {
    SvgContours contours;
    const std::vector<double>& levels = colouring.contours.values;
    if (levels.empty() || cell_dimension(snapshot.mesh->kind) != 2) return contours;
    const Tessellation shape = tessellate(*snapshot.mesh, cuts_for(*snapshot.mesh, snapshot.x));
    const Points shown = shown_points(shape, x);
    const auto lines = contour_lines(shape, shown_values(shape, colouring.values), levels);
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::int32_t> numbers;
    const auto number = [&](const ContourPoint& point, std::uint32_t level) {
        const auto [known, is_new] =
            numbers.emplace(std::tuple(level, point.a, point.b), static_cast<std::int32_t>(numbers.size()));
        if (is_new) {
            const Vec3 place = point.in(shown);
            contours.x.x.push_back(place.x);
            contours.x.y.push_back(place.y);
            contours.x.z.push_back(place.z);
        }
        return known->second;
    };
    for (const ContourSegment& line : lines) {
        contours.segments.push_back({number(line.from, line.level), number(line.to, line.level)});
        contours.cells.push_back(shape.triangle_cells[line.triangle]);
        contours.levels.push_back(levels[line.level]);
    }
    return contours;
}

} // namespace gaspard
