#include "core/tessellate/snapshot_section.hpp"

#include "core/tessellate/section.hpp"
#include "core/tessellate/visible_cells.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace gaspard {

Tessellation snapshot_section(const Snapshot& snapshot, const Points& x, const InsideChoice& inside,
                              ColouringMaker& maker, const std::string& colour) {
    const auto faces = std::make_shared<const SolidFaces>(solid_faces(*snapshot.mesh));
    const auto visible =
        visible_cells(*snapshot.mesh, *faces, inside, condition_values(maker, snapshot, inside, colour), x);
    return SectionMaker(snapshot.mesh, faces).make(x, visible, inside, cuts_for(*snapshot.mesh, snapshot.x));
}

/// Leaves the points of triangles and segments; those of hidden parts would extend the box of a file.
static Tessellation without_unused_points(const Tessellation& whole) {
    Tessellation kept = whole;
    kept.starts = {0}, kept.nodes.clear(), kept.weights.clear(), kept.segment_sides.clear();
    constexpr std::uint32_t unused = 0xffffffff;
    std::vector<std::uint32_t> numbers(whole.point_count, unused);
    kept.point_count = 0;
    const auto renumber = [&](std::uint32_t& point) {
        std::uint32_t& number = numbers[point];
        if (number == unused) {
            number = static_cast<std::uint32_t>(kept.point_count++);
            for (std::uint32_t k = whole.starts[point]; k < whole.starts[point + 1]; ++k)
                kept.nodes.push_back(whole.nodes[k]), kept.weights.push_back(whole.weights[k]);
            kept.starts.push_back(static_cast<std::uint32_t>(kept.nodes.size()));
        }
        point = number;
    };
    for (std::uint32_t& point : kept.triangles) renumber(point);
    for (std::uint32_t& point : kept.segments) renumber(point);
    return kept;
}

std::optional<Tessellation> surface_of_cut(const Snapshot& snapshot, const Values& view) {
    if (cell_dimension(snapshot.mesh->kind) != 3) return std::nullopt;
    const InsideChoice inside = inside_choice(view);
    if (!inside.looks_inside()) return std::nullopt;
    ColouringMaker maker;
    const Tessellation shape = snapshot_section(snapshot, snapshot.x, inside, maker, view.text("color"));
    if (shape.triangles.empty()) return std::nullopt;
    return without_unused_points(shape);
}

} // namespace gaspard
