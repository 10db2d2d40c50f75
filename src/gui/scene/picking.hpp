// Which cell or node of a scene is under a pointer, and the facts about it.
#pragma once

#include "core/tessellate/camera.hpp"
#include "core/tessellate/pick.hpp"
#include "gui/scene/mesh_scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

struct PickHit {
    Pick pick;
    Vec3 where; ///< the point of the mesh under the pointer
};
/// The nearest node within `reach` pixels, or less where cells are small, so that there is always a cell to
/// pick too; else the front-most cell under the pointer. At the positions of scene.blend.
std::optional<PickHit> pick_at(const MeshScene& scene, const Camera& camera, Size size, Pixel pointer,
                               double reach);

/// The lines around a cell in pixels, two points each. At the positions of scene.blend.
std::vector<std::pair<Pixel, Pixel>> outline_of(const MeshScene& scene, const Camera& camera, Size size,
                                                std::uint32_t cell);
/// Where a node is seen, or the middle of a cell's outline; nothing if it is inside a solid.
std::optional<Pixel> middle_of(const Pick& pick, const MeshScene& scene, const Camera& camera, Size size);

/// Whether the viewer sees any of it; the other side of a ball, and other cells of a solid, hide it.
bool faces_viewer(const Pick& pick, const MeshScene& scene, const Camera& camera);

/// The rows of a card: names and values; the first is a title without a name.
using PickFacts = std::vector<std::pair<std::string, std::string>>;
/// `cells` has seen the snapshot. A node tells the range of what belongs to the cells around it. What the
/// colours show comes first; null: nothing.
PickFacts facts_of(const Pick& pick, const Snapshot& snapshot, ColouringMaker& cells,
                   const Colouring* colouring = nullptr);

} // namespace gaspard
