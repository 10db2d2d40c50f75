// Meshes drawn quickly, beside the same drawn in full with as many samples a pixel.
#include "gui/gl/offscreen.hpp"
#include "gui/globes.hpp"
#include "gui/render/mesh_renderer.hpp"
#include "gui/scenes.hpp"
#include "gui/similarity.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace gaspard {
namespace {

constexpr int side = 600;

class MeshDrafts : public testing::Test {
  protected:
    Image draw(const MeshScene& scene, bool quickly, const Theme& theme = dark_theme()) {
        target_.bind();
        Camera camera = home(scene.box, {side, side});
        camera.scale *= zoom_;
        renderer_.draw(scene, camera, {0, 0, side, side}, side, theme, 1, quickly);
        EXPECT_EQ(context_->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        return target_.read();
    }
    MeshScene scene(const Snapshot& snapshot, const Values& values) { return maker_.make(snapshot, values); }
    /// `least`: of the similarity of the part that differs most; `most`: of the difference, of 255.
    void expect_alike(const std::string& what, const MeshScene& scene, double least, double most = 1.3) {
        for (const Theme& theme : {dark_theme(), light_theme()}) {
            const Image full = draw(scene, false, theme), quick = draw(scene, true, theme);
            EXPECT_NE(full.rgba, quick.rgba) << what << ": is no draft";
            const Similarity s = compare(full, quick);
            EXPECT_LT(s.mean_difference, most) << what << ", " << theme.background.r;
            EXPECT_GT(s.mean_structure, 0.985) << what << ", " << theme.background.r;
            EXPECT_GT(s.worst_structure, least) << what << ", " << theme.background.r;
        }
    }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context();
    RenderTarget target_{context_->gl(), side, side};
    MeshRenderer renderer_{context_->gl()};
    SceneBuilder maker_;
    double zoom_ = 1;
};

TEST_F(MeshDrafts, LookLikeTheFullImage) {
    for (const int n : {40, 120}) {
        const std::string cells = std::to_string(n) + " x " + std::to_string(n) + " cells";
        expect_alike(cells, scene(ring_snapshot(n), view("monitor", 1)), 0.95);
        expect_alike(cells + " without colours", scene(ring_snapshot(n), view("none", 1)), 0.95);
    }
    expect_alike("close lines", scene(ring_snapshot(300), view("none", 1)), 0.85);
    expect_alike("one colour for each cell", scene(ring_snapshot(40), view("area", 1)), 0.95);
    expect_alike("on the way from xi to x", scene(ring_snapshot(40), view("monitor", 0.4)), 0.95);
}

TEST_F(MeshDrafts, OfTrianglesAndGlobesLookLikeTheFullImage) {
    expect_alike("layers", scene(corner_layer_snapshot(32, 0.1), view("none", 1)), 0.95);
    const Snapshot globe = xn_globe(icosahedral_globe(5, 1), 4);
    expect_alike("a globe", scene(globe, view("monitor", 1)), 0.95);
    expect_alike("a globe without colours", scene(globe, view("none", 1)), 0.9);
    expect_alike("a globe of squares", scene(xn_globe(cubed_globe(32, 1), 4), view("area", 1)), 0.95);
}

/// Also where a part of a cell touches an edge with a corner only: lines have no holes there.
TEST_F(MeshDrafts, OfCurvedCellsLookLikeTheFullImage) {
    zoom_ = 0.5; // so that their parts are large enough
    const Snapshot squares = xn_globe(cubed_globe(12, 2), 4);
    expect_alike("curved squares", scene(squares, view("monitor", 1)), 0.98, 0.25);
    expect_alike("curved squares without colours", scene(squares, view("none", 1)), 0.98, 0.25);
    // A cell's half of an edge has the ink for its own colour.
    expect_alike("one colour for each curved square", scene(squares, view("area", 1)), 0.88, 0.55);
    expect_alike("curved triangles", scene(xn_globe(icosahedral_globe(3, 2), 4), view("monitor", 1)), 0.98,
                 0.45);
    expect_alike("curved triangles without colours",
                 scene(xn_globe(icosahedral_globe(4, 2), 4), view("none", 1)), 0.98, 0.8);
}

TEST_F(MeshDrafts, HaveNoLinesIfThereAreNone) {
    Values values = view("none", 1);
    values.set("lines", false);
    const Image quick = draw(scene(ring_snapshot(40), values), true);
    EXPECT_EQ(difference(quick, draw(scene(ring_snapshot(40), values), false)), "");
}

/// What lies over other cells would be hidden.
TEST_F(MeshDrafts, AreNotMadeOfTangledMeshes) {
    const MeshScene tangled = scene(tangled_snapshot(20), view("monitor", 1));
    EXPECT_EQ(draw(tangled, true).rgba, draw(tangled, false).rgba);
}

} // namespace
} // namespace gaspard
