#include "core/io/svg_section.hpp"

#include "core/tessellate/contours.hpp"
#include "core/tessellate/snapshot_section.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

std::int32_t signed_number(std::uint32_t point) { return static_cast<std::int32_t>(point); }

bool before(const SectionSide& a, const SectionSide& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
}

/// The mean over the corners of each triangle, or the value of its cell.
std::vector<double> triangle_values(const Tessellation& shape, const Colouring& colouring) {
    std::vector<double> values(shape.triangle_cells.size());
    const bool of_cells = colouring.place == FieldPlace::cell;
    const auto points = of_cells ? std::vector<double>() : shown_values(shape, colouring.values);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = of_cells ? colouring.values[shape.triangle_cells[i]]
                             : (points[shape.triangles[3 * i]] + points[shape.triangles[3 * i + 1]] +
                                points[shape.triangles[3 * i + 2]]) /
                                   3;
    return values;
}

/// Both ends of every contour line are points of its own.
void add_contours(SvgScene& scene, const Tessellation& shape, const Colouring& colouring, const Points& x) {
    const std::vector<double>& levels = colouring.contours.values;
    if (levels.empty()) return;
    for (const ContourSegment& line : contour_lines(shape, shown_values(shape, colouring.values), levels)) {
        const auto first = static_cast<std::int32_t>(scene.contours.x.size());
        for (const ContourPoint& end : {line.from, line.to}) {
            const Vec3 place = end.in(x);
            scene.contours.x.x.push_back(place.x);
            scene.contours.x.y.push_back(place.y);
            scene.contours.x.z.push_back(place.z);
        }
        scene.contours.segments.push_back({first, first + 1});
        scene.contours.cells.push_back(line.triangle);
        scene.contours.levels.push_back(levels[line.level]);
    }
}

void append(Points& points, const Points& more) {
    points.x.insert(points.x.end(), more.x.begin(), more.x.end());
    points.y.insert(points.y.end(), more.y.begin(), more.y.end());
    points.z.insert(points.z.end(), more.z.begin(), more.z.end());
}

} // namespace

SvgScene svg_section(const Snapshot& snapshot, double blend, const std::optional<Colouring>& colouring,
                     const InsideChoice& inside) {
    ColouringMaker maker;
    Points x = snapshot.x;
    for (std::size_t i = 0; blend != 1 && i < x.size(); ++i)
        x.set(i, (1 - blend) * snapshot.mesh->nodes[i] + blend * snapshot.x[i]);
    const Tessellation shape =
        snapshot_section(snapshot, x, inside, maker, colouring ? colouring->name : "none");
    SvgScene scene;
    scene.x = shown_points(shape, x);
    scene.xi = shown_points(shape, snapshot.mesh->nodes);
    if (colouring) scene.values = triangle_values(shape, *colouring);
    if (colouring) add_contours(scene, shape, *colouring, scene.x);
    append(scene.x, x); // of no face; the whole mesh says what the page shows
    append(scene.xi, snapshot.mesh->nodes);
    scene.spatial = scene.closed = scene.section = true;
    scene.caps = shape.caps;
    scene.faces.kind = {CellShape::triangle, 1};
    scene.faces.corners = scene.faces.nodes_each = 3;
    scene.faces.cells = shape.triangle_cells;
    for (const std::uint32_t point : shape.triangles) scene.faces.nodes.push_back(signed_number(point));
    const std::vector<std::uint32_t> tangled = maker.tangled(snapshot);
    for (const std::uint32_t cell : scene.faces.cells)
        scene.tangled.push_back(std::binary_search(tangled.begin(), tangled.end(), cell));
    for (std::size_t i = 0; i < shape.segments.size(); i += 2) {
        const auto [from, to] =
            std::minmax({signed_number(shape.segments[i]), signed_number(shape.segments[i + 1])});
        scene.section_sides.push_back(
            {from, to, signed_number(shape.segment_sides[i]), signed_number(shape.segment_sides[i + 1])});
    }
    std::sort(scene.section_sides.begin(), scene.section_sides.end(), before);
    return scene;
}

const SectionSide* find_section_side(const SvgScene& scene, std::int32_t a, std::int32_t b) {
    const SectionSide wanted{std::min(a, b), std::max(a, b)};
    const auto& sides = scene.section_sides;
    const auto found = std::lower_bound(sides.begin(), sides.end(), wanted, before);
    return found != sides.end() && found->from == wanted.from && found->to == wanted.to ? &*found : nullptr;
}

} // namespace gaspard
