// Which cell or node of a picture is under a pointer, and what is known of it. Pure: pixels, points and
// words.
#pragma once

#include "gui/scene/camera.hpp"
#include "gui/scene/mesh_scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

/// A cell or a node by its number in the mesh.
struct Pick {
    enum class Kind { cell, node };
    Kind kind = Kind::cell;
    std::uint32_t index = 0;
    friend bool operator==(const Pick&, const Pick&) = default;
};

/// "cell 12", "node 7"
std::string format_pick(const Pick& pick);
/// Nothing for an empty text. Throws InputError where it is neither.
std::optional<Pick> parse_pick(std::string_view text);
/// Whether the mesh has it.
bool has(const Mesh& mesh, const Pick& pick);

struct PickHit {
    Pick pick;
    Vec3 where; ///< the point of the mesh under the pointer
};
/// The nearest node within `reach` pixels, or less where cells are small, so that there is always a cell to
/// pick too; else the front-most cell under the pointer. Follows picture.blend.
std::optional<PickHit> pick_at(const MeshScene& scene, const Camera& camera, Size size, Pixel pointer,
                               double reach);

/// The lines around a cell in pixels, two points each. Follows picture.blend.
std::vector<std::pair<Pixel, Pixel>> outline_of(const MeshScene& scene, const Camera& camera, Size size,
                                                std::uint32_t cell);
/// Where a node is seen, or the middle of a cell's outline; nothing if it is inside a solid.
std::optional<Pixel> middle_of(const Pick& pick, const MeshScene& scene, const Camera& camera, Size size);

/// Whether the viewer sees any of it; on a ball its own other side hides it.
bool faces_viewer(const Pick& pick, const MeshScene& scene, const Camera& camera);

/// What a card says: pairs of a name and a value, the first one a title without a name.
using PickFacts = std::vector<std::pair<std::string, std::string>>;
/// `cells` has seen the snapshot. A node tells the range of what belongs to the cells around it.
PickFacts facts_of(const Pick& pick, const Snapshot& snapshot, ColouringMaker& cells);

} // namespace gaspard
