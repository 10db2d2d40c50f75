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

/// nullopt if the view does not look into a solid; without triangles if nothing is left.
static std::optional<Tessellation> section_of_view(const Snapshot& snapshot, const Values& view) {
    if (cell_dimension(snapshot.mesh->kind) != 3) return std::nullopt;
    const InsideChoice inside = inside_choice(view);
    if (!inside.looks_inside()) return std::nullopt;
    ColouringMaker maker;
    return snapshot_section(snapshot, snapshot.x, inside, maker, view.text("color"));
}

std::optional<Tessellation> surface_of_cut(const Snapshot& snapshot, const Values& view) {
    const auto shape = section_of_view(snapshot, view);
    if (!shape || shape->triangles.empty()) return std::nullopt;
    return without_unused_points(*shape);
}

std::string nothing_left(const Values& view) {
    std::vector<std::string> keys;
    for (const char* key : {"cut", "peel", "layers", "only"})
        if (!is_default(view, key)) keys.push_back(std::string("view.") + key);
    std::string text;
    for (std::size_t i = 0; i < keys.size(); ++i)
        text += (i == 0 ? "" : i + 1 == keys.size() ? " and " : ", ") + keys[i];
    return text + (keys.size() == 1 ? " leaves" : " leave") + " nothing to see of the solid";
}

std::string note_on_hidden(const Snapshot& snapshot, const Values& view) {
    const auto shape = section_of_view(snapshot, view);
    return shape && shape->triangles.empty() ? nothing_left(view) : std::string();
}

} // namespace gaspard
