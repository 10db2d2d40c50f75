// What to draw of a mesh, as plain data: made from a snapshot, drawn by MeshRenderer, and readable by tests.
//
// Arrays are shared and immutable: another array (another pointer) is another version, and only that is
// uploaded.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/colour_map.hpp"
#include "core/tessellate/tessellation.hpp"
#include "gui/camera.hpp"
#include "gui/theme.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct MeshPicture {
    std::shared_ptr<const Tessellation> tessellation;
    int cell_dimension = 2;                            ///< 1: nodes are marked by discs
    std::shared_ptr<const Points> computational;       ///< shown points at xi
    std::shared_ptr<const Points> physical;            ///< shown points at x
    std::shared_ptr<const std::vector<double>> scalar; ///< per shown point; null: no colour map
    std::string scalar_name;                           ///< for the legend
    std::string_view map = "viridis";
    ColourRange range;
    std::shared_ptr<const std::vector<std::uint32_t>> tangled; ///< cells; null: none
    Box box;                                                   ///< around both meshes
    double blend = 1;                                          ///< 0 shows xi, 1 shows x

    bool planar() const { return box.low.z == box.high.z; }
};

/// Makes pictures of one run's snapshots; keeps what does not change between them.
class PictureMaker {
  public:
    /// `colour`: the name of a field of the nodes ("monitor"), or "none".
    MeshPicture make(const Snapshot& snapshot, std::string_view colour, double blend);

  private:
    std::shared_ptr<const Mesh> mesh_;
    std::shared_ptr<const Tessellation> tessellation_;
    std::shared_ptr<const Points> computational_;
    Box computational_box_;
    MeshPicture last_;
    std::uint64_t last_version_ = 0;
};

} // namespace gaspard
