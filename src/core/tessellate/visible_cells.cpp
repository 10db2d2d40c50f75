#include "core/tessellate/visible_cells.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace gaspard {

namespace {

void hide_layers(const Mesh& mesh, const std::array<LayerRange, 3>& layers, std::vector<char>& visible) {
    if (layers == std::array<LayerRange, 3>{}) return;
    const auto count = [&](std::size_t d) { return static_cast<std::uint32_t>(mesh.lattice[d]); };
    if (std::size_t{count(0)} * count(1) * count(2) != visible.size()) return; // it is no lattice
    for (std::uint32_t c = 0; c < visible.size(); ++c) {
        const std::array<std::uint32_t, 3> at = {c % count(0), c / count(0) % count(1),
                                                 c / count(0) / count(1)};
        for (std::size_t d = 0; d < 3; ++d)
            if (at[d] < layers[d].first || at[d] > layers[d].last) visible[c] = 0;
    }
}

/// Those whose middle is beyond the planes.
void hide_whole(const Mesh& mesh, const std::vector<CutWedge>& cut, const Points& x,
                std::vector<char>& visible) {
    for (std::size_t c = 0; c < visible.size(); ++c) {
        if (visible[c] == 0) continue;
        Vec3 middle;
        for (const std::int32_t node : mesh.cell(c).first(8))
            middle = middle + 0.125 * x[static_cast<std::size_t>(node)];
        const auto beyond = [&](const CutPlane& plane) { return plane.distance(middle) > 0; };
        for (const CutWedge& wedge : cut)
            if (std::all_of(wedge.begin(), wedge.end(), beyond)) visible[c] = 0;
    }
}

} // namespace

std::vector<char> visible_cells(const Mesh& mesh, const SolidFaces& faces, const InsideChoice& choice,
                                std::span<const std::vector<double>> values, const Points& x) {
    std::vector<char> visible(mesh.cell_count(), 1);
    for (std::size_t c = 0; choice.peel > 0 && c < visible.size(); ++c)
        visible[c] = faces.depths[c] >= choice.peel ? 1 : 0;
    hide_layers(mesh, choice.layers, visible);
    GASPARD_CHECK(values.size() == choice.only.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t c = 0; !values[i].empty() && c < visible.size(); ++c)
            if (!choice.only[i].holds(values[i][c])) visible[c] = 0;
    if (choice.whole_cells) hide_whole(mesh, choice.cut, x, visible);
    return visible;
}

std::vector<std::vector<double>> condition_values(ColouringMaker& maker, const Snapshot& snapshot,
                                                  const InsideChoice& choice, const std::string& colour) {
    std::vector<std::vector<double>> values;
    for (const CellCondition& condition : choice.only) {
        ColourChoice wish;
        wish.colouring = condition.of == "value" ? colour : condition.of;
        const auto found = maker.make(snapshot, wish);
        if (!found)
            values.emplace_back();
        else
            values.push_back(found->place == FieldPlace::cell ? found->values
                                                              : corner_means(*snapshot.mesh, found->values));
    }
    return values;
}

std::vector<double> corner_means(const Mesh& mesh, std::span<const double> nodes) {
    GASPARD_CHECK(nodes.size() == mesh.node_count());
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    std::vector<double> means(mesh.cell_count(), 0);
    for (std::size_t c = 0; c < means.size(); ++c) {
        for (const std::int32_t node : mesh.cell(c).first(corners))
            means[c] += nodes[static_cast<std::size_t>(node)];
        means[c] /= static_cast<double>(corners);
    }
    return means;
}

} // namespace gaspard
