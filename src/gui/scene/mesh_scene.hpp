// What to draw of a mesh, as plain data: made from a snapshot and a view, drawn by MeshRenderer, and readable
// by tests.
//
// Arrays are shared and immutable: another array (another pointer) is another version, and only that is
// uploaded.
#pragma once

#include "core/base/parameter.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/camera.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/sphere_map.hpp"
#include "core/tessellate/tessellation_cache.hpp"
#include "gui/scene/section_worker.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

/// Lines of another mesh over a scene.
struct MeshOverlay {
    std::shared_ptr<const Tessellation> tessellation;
    std::shared_ptr<const Points> points;
};

/// Contour lines of the colours (core/tessellate/contours.hpp): two points per segment.
struct MeshContours {
    Points computational, physical;
    std::vector<double> values; ///< the level, per point
};

struct MeshScene {
    std::shared_ptr<const Tessellation> tessellation;
    int cell_dimension = 2;                      ///< 1: cells are lines, nodes are marked by discs
    std::shared_ptr<const Points> computational; ///< shown points at xi
    std::shared_ptr<const Points> physical;      ///< shown points at x
    std::shared_ptr<const Colouring> colouring;  ///< null: no colour map
    /// Per shown point what the colouring shows there (of cells: the mean around), null without a colouring.
    std::shared_ptr<const std::vector<double>> point_values;
    std::shared_ptr<const MeshContours> contours;              ///< null: none
    std::shared_ptr<const std::vector<std::uint32_t>> tangled; ///< cells; null: none
    std::shared_ptr<const std::vector<std::uint32_t>>
        arrows;                                 ///< shown points with an arrow from xi to x; null: none
    std::shared_ptr<const MeshOverlay> overlay; ///< null: none
    std::shared_ptr<const Mesh> mesh;
    double ball = 0; ///< radius of the sphere around the origin that all nodes of the mesh lie on; 0: none
    std::optional<MapProjection> projection; ///< the scene is a projection of that ball; its blend is 1
    /// All nodes at x where some of a solid is hidden (core/tessellate/inside_choice.hpp); else null.
    std::shared_ptr<const Points> nodes;
    Box box;            ///< around both meshes, with what is hidden of them
    bool burst = false; ///< the physical mesh is far larger than the computational one: it has diverged
    /// What "home" shows: both meshes, or the computational one and its target if the other has burst.
    Box home_box;
    double blend = 1;     ///< 0 shows xi, 1 shows x
    double elevation = 0; ///< factor of the heights of a plane mesh, which is then a surface; 0: flat
    bool lines = true;    ///< the cells' edges

    /// The same scene: arrays are compared by pointer.
    friend bool operator==(const MeshScene&, const MeshScene&) = default;
    bool planar() const { return box.low.z == box.high.z; }
    /// Cells are filled with one colour each.
    bool flat() const { return colouring != nullptr && colouring->place == FieldPlace::cell; }
};

/// The position of a point in a scene, by its blend; on a ball every blend lies on the ball.
Vec3 shown_point(const MeshScene& scene, std::uint32_t point);

/// At the levels of the scene's colouring; null if there are none.
std::shared_ptr<const MeshContours> make_contours(const MeshScene& scene);

/// Makes scenes of the snapshots of one run; keeps what does not change between them.
class SceneBuilder {
  public:
    explicit SceneBuilder(std::shared_ptr<TessellationCache> cache = std::make_shared<TessellationCache>())
        : cache_(std::move(cache)) {}
    /// `view`: values of view_rows(). Without the arrows, which depend on the camera.
    MeshScene make(const Snapshot& snapshot, const Values& view);
    const std::shared_ptr<TessellationCache>& cache() const { return cache_; }
    /// From now on sections of solids that take long are made on another thread, and shown once they are
    /// there; until then what was shown before.
    void work_in_background() { worker_ = std::make_unique<SectionWorker>(); }
    /// Whether the next scene may differ because such a section will be there.
    bool awaits_section() const { return worker_ && worker_->busy(); }
    /// What is known of the cells; of the snapshot last shown.
    ColouringMaker& cells() { return colouring_maker_; }

  private:
    /// Arrays that no scene uses any more, to avoid an allocation with every snapshot.
    std::shared_ptr<Points> available();
    std::shared_ptr<const Tessellation> section(const Snapshot& snapshot, const Values& view);
    std::shared_ptr<const Tessellation> finished_section(const std::shared_ptr<const Mesh>& mesh);
    void take_mesh(const Snapshot& snapshot, std::shared_ptr<const Tessellation> tessellation);
    void take_positions(const Snapshot& snapshot);
    void take_elevation(double factor);
    void take_tangled(const Snapshot& snapshot);
    void take_overlay(const Snapshot& snapshot, bool wanted);
    void take_colouring(const Snapshot& snapshot, const ColourChoice& choice);
    void take_point_values();

    std::shared_ptr<TessellationCache> cache_;
    std::shared_ptr<const Mesh> mesh_;
    Box computational_box_, target_box_; ///< of the flat mesh, as the two below; where it is to lie
    InsideChoice inside_;                ///< what was asked for
    SectionMaking section_making_;
    double section_seconds_ = 0;                           ///< that the last section took
    std::uint64_t section_number_ = 0, shown_section_ = 0; ///< of the last one asked for, and of that shown
    std::unique_ptr<SectionWorker> worker_;
    std::shared_ptr<const Points> computational_, physical_;
    double elevation_ = 0; ///< what was asked for
    ColouringMaker colouring_maker_;
    ColourChoice choice_;
    std::shared_ptr<const Points> exact_; ///< what the overlay was made of
    MeshScene last_;
    std::uint64_t last_version_ = 0;
    std::vector<std::shared_ptr<Points>> workspaces_;
};

} // namespace gaspard
