// Contexts without a window, and what the renderer sends to the graphics card.
#include "core/base/error.hpp"
#include "gui/gl/offscreen.hpp"
#include "gui/globes.hpp"
#include "gui/render/mesh_renderer.hpp"
#include "gui/scenes.hpp"
#include "gui/similarity.hpp"
#include "support/messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {
namespace {

/// Those of this machine: OSMesa is not part of Mesa after 25.0.
std::vector<OffscreenBackend> installed_backends() {
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6"})
        if (dlopen(name, RTLD_NOW | RTLD_LOCAL) != nullptr)
            return {OffscreenBackend::osmesa, OffscreenBackend::egl};
    return {OffscreenBackend::egl};
}

std::string_view name_of(OffscreenBackend backend) {
    return backend == OffscreenBackend::osmesa ? "OSMesa" : "EGL";
}

/// Sets GASPARD_OFFSCREEN for its own lifetime.
class Chosen {
  public:
    explicit Chosen(const char* backend) {
        if (const char* value = std::getenv("GASPARD_OFFSCREEN")) before_ = value;
        setenv("GASPARD_OFFSCREEN", backend, 1);
    }
    ~Chosen() { setenv("GASPARD_OFFSCREEN", before_.c_str(), 1); }
    Chosen(const Chosen&) = delete;
    Chosen& operator=(const Chosen&) = delete;

  private:
    std::string before_;
};

TEST(Offscreen, TriesOsMesaFirst) {
    const Chosen none("");
    EXPECT_EQ(make_offscreen_context()->backend(), name_of(installed_backends().front()));
}

TEST(Offscreen, EveryBackendCanBeChosen) {
    for (const auto backend : installed_backends()) {
        EXPECT_EQ(make_offscreen_context(backend)->backend(), name_of(backend));
        const Chosen chosen(backend == OffscreenBackend::osmesa ? "osmesa" : "egl");
        EXPECT_EQ(make_offscreen_context()->backend(), name_of(backend));
    }
    const Chosen unknown("glx");
    EXPECT_EQ(message_of<InputError>([] { make_offscreen_context(); }),
              "the environment variable GASPARD_OFFSCREEN is \"glx\"; allowed: osmesa, egl");
}

TEST(Offscreen, ContextsComeAndGo) {
    for (int i = 0; i < 3; ++i)
        for (const auto backend : installed_backends()) {
            const auto context = make_offscreen_context(backend);
            const RenderTarget target(context->gl(), 8, 4);
            target.bind();
            context->gl().ClearColor(1, 0, 0.2F, 1);
            context->gl().Clear(GL_COLOR_BUFFER_BIT);
            const Image image = target.read();
            ASSERT_EQ(image.rgba.size(), 8U * 4 * 4);
            EXPECT_EQ(image.rgba[0], 255);
            EXPECT_EQ(image.rgba[1], 0);
            EXPECT_EQ(image.rgba[2], 51);
        }
}

TEST(Offscreen, RowsRunFromTopToBottom) {
    const auto context = make_offscreen_context();
    const Gl& gl = context->gl();
    const RenderTarget target(gl, 4, 4);
    target.bind();
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 3, 4, 1); // the uppermost row, as OpenGL counts
    gl.ClearColor(1, 1, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    const Image image = target.read();
    EXPECT_EQ(image.rgba[0], 255);
    EXPECT_EQ(image.rgba[3 * 4 * 4], 0);
}

TEST(Offscreen, ATooLargePictureIsTheMachinesLimit) {
    const auto context = make_offscreen_context();
    EXPECT_NE(message_of<MachineError>([&] { RenderTarget(context->gl(), 1000000, 10); }).find("at most"),
              std::string::npos);
}

TEST(Gl, AMissingFunctionIsNamed) {
    const std::string text =
        message_of<MachineError>([] { load_gl([](const char*) -> void* { return nullptr; }); });
    EXPECT_NE(text.find("glActiveTexture"), std::string::npos) << text;
    EXPECT_NE(text.find("3.3"), std::string::npos) << text;
}

class Renderer : public testing::Test {
  protected:
    void draw(const MeshScene& scene) {
        target_.bind();
        renderer_.draw(scene, home(scene.box, size_), {0, 0, 320, 240}, 240, dark_theme(), 1);
        EXPECT_EQ(context_->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
    /// Bytes sent for one more picture.
    std::size_t sent_for(const MeshScene& scene) {
        const std::size_t before = renderer_.uploaded_bytes();
        draw(scene);
        return renderer_.uploaded_bytes() - before;
    }

    Size size_{320, 240};
    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context();
    RenderTarget target_{context_->gl(), 320, 240};
    MeshRenderer renderer_{context_->gl()};
    SceneBuilder maker_;
};

TEST_F(Renderer, SendsOnlyWhatChanged) {
    Snapshot snapshot = ring_snapshot(20);
    const std::size_t points = snapshot.x.size() * 16, cells = snapshot.mesh->cell_count() * 4;
    EXPECT_GT(sent_for(maker_.make(snapshot, view("monitor", 1))), 2 * points);
    EXPECT_EQ(sent_for(maker_.make(snapshot, view("monitor", 1))), 0U);
    EXPECT_EQ(sent_for(maker_.make(snapshot, view("monitor", 0.3))), 0U) << "blending is done on the card";
    ++snapshot.version;
    EXPECT_EQ(sent_for(maker_.make(snapshot, view("monitor", 1))), points) << "positions and values";
    EXPECT_EQ(sent_for(maker_.make(snapshot, view("area", 1))), points + cells) << "one number per cell";
    EXPECT_EQ(sent_for(maker_.make(snapshot, view("area", 0.5))), 0U);
    Values other = view("area", 1);
    other.set("color_map", std::string("grey"));
    EXPECT_GT(sent_for(maker_.make(snapshot, other)), 0U);
    MeshScene arrows = maker_.make(snapshot, other);
    arrows.arrows = std::make_shared<const std::vector<std::uint32_t>>(7, 3U);
    EXPECT_EQ(sent_for(arrows), 7U * 4);
    EXPECT_EQ(sent_for(arrows), 0U);
}

TEST_F(Renderer, DrawsIntoItsAreaOnly) {
    const MeshScene scene = maker_.make(ring_snapshot(10), view("monitor", 1));
    const Gl& gl = context_->gl();
    target_.bind();
    gl.ClearColor(1, 1, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    Camera camera = home(scene.box, {100, 80});
    camera.scale /= 10; // the mesh is larger than the area
    renderer_.draw(scene, camera, {40, 30, 100, 80}, 240, dark_theme(), 1);
    const Image image = target_.read();
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
            const bool inside = x >= 40 && x < 140 && y >= 30 && y < 110;
            const auto at = static_cast<std::size_t>(y * 320 + x) * 4;
            const bool white =
                image.rgba[at] == 255 && image.rgba[at + 1] == 255 && image.rgba[at + 2] == 255;
            ASSERT_EQ(white, !inside) << x << ", " << y;
        }
}

TEST_F(Renderer, ACurvedMeshThatMovesIsDividedLessAndLooksTheSame) {
    const MeshScene scene = maker_.make(xn_globe(icosahedral_globe(3, 2), 4), view("monitor", 1));
    ASSERT_GT(scene.tessellation->triangle_cells.size(), 30'000U);
    const auto draw_globe = [&](bool quickly) {
        const std::size_t before = renderer_.uploaded_bytes();
        target_.bind();
        renderer_.draw(scene, home(scene.box, size_), {0, 0, 320, 240}, 240, dark_theme(), 1, quickly);
        EXPECT_EQ(context_->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        return renderer_.uploaded_bytes() - before;
    };
    draw_globe(false);
    const Image full = target_.read();
    EXPECT_GT(draw_globe(true), 0U) << "fewer triangles, sent when they are first needed";
    const Image quick = target_.read();
    EXPECT_NE(quick.rgba, full.rgba);
    EXPECT_EQ(difference(quick, full), "");
    EXPECT_EQ(draw_globe(true), 0U) << "and only once";
    draw_globe(false);
    EXPECT_EQ(target_.read().rgba, full.rgba);
}

TEST_F(Renderer, ShowsOneMeshAfterAnother) {
    draw(maker_.make(ring_snapshot(10), view("monitor", 1)));
    draw(maker_.make(sphere_snapshot(3), view("monitor", 1)));
    const Image after_others = (draw(maker_.make(ring_snapshot(5), view("none", 1))), target_.read());
    MeshRenderer fresh(context_->gl());
    const MeshScene scene = maker_.make(ring_snapshot(5), view("none", 1));
    target_.bind();
    fresh.draw(scene, home(scene.box, size_), {0, 0, 320, 240}, 240, dark_theme(), 1);
    EXPECT_EQ(after_others.rgba, target_.read().rgba);
}

/// The difference of two colours, in steps of 1/255 of a channel.
int distance(const Image& image, int x, int y, std::array<unsigned char, 3> colour) {
    const auto at = static_cast<std::size_t>(y * image.width + x) * 4;
    int largest = 0;
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(image.rgba[at + i] - colour[i]));
    return largest;
}

/// Four squares with values at their corners; `middle` is where the node between them is.
Snapshot four_cells(Vec3 middle) {
    Snapshot snapshot = ring_snapshot(2);
    snapshot.x = snapshot.mesh->nodes;
    snapshot.x.set(4, middle);
    for (Field& field : snapshot.fields)
        if (field.name == "monitor") field.values = {0, 3, 1, 2, 10, 5, 7, 4, 0};
    return snapshot;
}

TEST_F(Renderer, NodalValuesAreBilinearInAQuadrilateral) {
    Values values = view("monitor", 1);
    values.set("lines", false);
    values.set("log", false);
    for (const Vec3 middle : {Vec3{0.5, 0.5, 0}, {0.62, 0.41, 0}, {0.35, 0.36, 0}}) {
        const Snapshot snapshot = four_cells(middle);
        const MeshScene scene = maker_.make(snapshot, values);
        draw(scene);
        const Image image = target_.read();
        const Camera camera = home(scene.box, size_);
        int compared = 0;
        for (std::size_t cell = 0; cell < 4; ++cell)
            for (int k = 1; k < 40; ++k)
                for (int l = 1; l < 40; ++l) {
                    // The place of these coordinates in the cell, and the value there.
                    const double s = k / 40.0, t = l / 40.0;
                    const std::array weights{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
                    Vec3 place;
                    double value = 0;
                    for (std::size_t c = 0; c < 4; ++c) {
                        const auto node = static_cast<std::size_t>(snapshot.mesh->cell(cell)[c]);
                        place = place + weights[c] * snapshot.x[node];
                        value += weights[c] * scene.colouring->values[node];
                    }
                    const Pixel pixel = to_pixel(camera, size_, place);
                    const double away =
                        std::hypot(pixel.x - std::floor(pixel.x) - 0.5, pixel.y - std::floor(pixel.y) - 0.5);
                    if (away > 0.1) continue; // not in the middle of a pixel
                    const auto colour =
                        colour_at(*scene.colouring->map, scene.colouring->range.position(value));
                    EXPECT_LE(distance(image, static_cast<int>(pixel.x), static_cast<int>(pixel.y), colour),
                              3)
                        << "cell " << cell << ", " << s << ", " << t << ": " << value;
                    ++compared;
                }
        EXPECT_GT(compared, 50);
    }
}

TEST(Facets, PairTheTrianglesOfQuadrilaterals) {
    const Tessellation squares = tessellate(*ring_snapshot(2).mesh);
    const DrawnFacets facets = make_facets(squares, true);
    ASSERT_EQ(facets.facets.size(), 4U);
    EXPECT_EQ(facets.facets[0], (Facet{0, 1, 4, 3})) << "in order around the first cell";
    ASSERT_EQ(facets.corners.size(), squares.triangles.size());
    for (std::size_t i = 0; i < squares.triangles.size(); i += 3) {
        const std::uint32_t* triangle = &squares.triangles[i];
        std::array<std::uint32_t, 3> points{};
        for (std::size_t k = 0; k < 3; ++k)
            points[k] = facets.facets[facets.corners[i + k] / 4][facets.corners[i + k] % 4];
        EXPECT_TRUE(std::is_permutation(points.begin(), points.end(), triangle)) << "triangle " << i / 3;
        EXPECT_EQ(facets.corners[i + 2] % 4, i % 6 == 0 ? 3U : 1U) << "the last corner names the half";
    }
    EXPECT_EQ(make_facets(squares, false).facets.size(), 8U);
    Tessellation cut = squares; // as at the border of a map
    cut.triangles[0] = 8;
    cut.triangles[1] = 7;
    EXPECT_EQ(make_facets(cut, true).facets.size(), 5U);
}

TEST_F(Renderer, LinesAreAsWideAsTheThemeSaysAtAnyZoom) {
    Snapshot snapshot = ring_snapshot(2);
    snapshot.x = snapshot.mesh->nodes;
    const MeshScene scene = maker_.make(snapshot, view("none", 1));
    const Theme theme = dark_theme();
    for (const double closer : {1.0, 3.0, 20.0}) {
        Camera camera = home(scene.box, size_);
        camera.scale /= closer;
        pan(camera, {5.5, -30});
        target_.bind();
        renderer_.draw(scene, camera, {0, 0, 320, 240}, 240, theme, 4);
        const Image image = target_.read();
        // The vertical line through the middle, summed over a row: how much of the way from the cells around
        // it to the line's full colour the pixels have gone. Pixels that it covers whole have gone all of it.
        const double full = static_cast<double>(
            theme.surface.r + theme.line_on_dark.a * (theme.line_on_dark.r - theme.surface.r));
        double ink = 0, most = 0;
        for (int x = 140; x < 190; ++x) {
            const auto at = static_cast<std::size_t>(60 * 320 + x) * 4;
            const double share = (image.rgba[at] / 255.0 - static_cast<double>(theme.surface.r)) /
                                 (full - static_cast<double>(theme.surface.r));
            ink += std::pow(std::max(0.0, share), 1 / 0.62); // as line_layer.frag has it: light adds up
            most = std::max(most, share);
        }
        EXPECT_NEAR(ink, 0.7 * 4, 0.07) << closer;
        EXPECT_NEAR(most, 1, 0.01) << closer;
    }
}

} // namespace
} // namespace gaspard
