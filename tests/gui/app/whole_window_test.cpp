// The picture of the window: what is drawn quickly, on another thread, and only where it has changed.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "gui/app/whole_window.hpp"
#include "gui/gl/imgui_context.hpp"

#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>
#include <mutex>

namespace gaspard {
namespace {

FinishedRun small_run(const std::shared_ptr<const Catalogue>& catalogue) {
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario, {"domain.cells=12"});
    gaspard::Run run(catalogue, scenario);
    run.solve();
    return {scenario, run.history(), run.snapshot()};
}

constexpr WindowPixels pixels{900, 640, 1};

/// A window in memory of a finished run.
class WindowInMemory : public ::testing::Test {
  public:
    WindowInMemory() {
        ImGui::GetIO().DisplaySize = {900, 640};
        load_font(*ImGui::GetIO().Fonts, dark_theme(), 1);
        apply_theme(dark_theme(), 1);
    }
    MeshesToDraw meshes() {
        for (int i = 0; i < 2; ++i) {
            ImGui::NewFrame();
            application_.frame();
            ImGui::Render();
        }
        return meshes_to_draw(application_, pixels, 1);
    }
    Values& view() { return application_.document().viewports().front().view; }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(OffscreenBackend::any);
    ImGuiSession session_;
    std::shared_ptr<const Catalogue> catalogue_ = std::make_shared<const Catalogue>(builtin_catalogue());
    Application application_{catalogue_, small_run(catalogue_)};
};

/// Part of a larger image.
Image cut_out(const Image& image, PixelRect part) {
    Image cut{part.width, part.height, {}};
    for (int y = part.y; y < part.y + part.height; ++y) {
        const auto row = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + part.x);
        cut.rgba.insert(cut.rgba.end(), row, row + 4 * static_cast<std::ptrdiff_t>(part.width));
    }
    return cut;
}

TEST_F(WindowInMemory, DrawsMeshesQuicklyOrInFull) {
    MeshImage image(context_->gl()), other(context_->gl());
    const MeshesToDraw what = meshes();
    EXPECT_TRUE(image.draw(what, true));
    const Image quick = image.image().read();
    EXPECT_TRUE(image.draw(what));
    const Image full = image.image().read();
    EXPECT_NE(full.rgba, quick.rgba) << "with several samples a pixel";
    other.draw(what);
    EXPECT_EQ(other.image().read().rgba, full.rgba) << "as if it had never been drawn quickly";
    EXPECT_FALSE(image.draw(what, false, [] { return true; }));
    EXPECT_TRUE(image.draw(what, false, [] { return false; }));
    EXPECT_EQ(image.image().read().rgba, full.rgba) << "what was given up leaves no trace";
}

TEST_F(WindowInMemory, DrawsTheAreaOfTheMeshesAsAPartOfTheWhole) {
    MeshImage image(context_->gl());
    MeshesToDraw what = meshes();
    const PixelRect area = what.area;
    EXPECT_LT(area.width, 900);
    EXPECT_GT(area.x, 100);
    what.area = {0, 0, 900, 640};
    image.draw(what);
    const Image whole = image.image().read();
    what.area = area;
    image.draw(what);
    const Image part = image.image().read(), expected = cut_out(whole, what.area);
    ASSERT_EQ(part.rgba.size(), expected.rgba.size());
    std::size_t rounded = 0; // differently, from another origin
    for (std::size_t i = 0; i < part.rgba.size(); ++i) {
        ASSERT_LE(std::abs(part.rgba[i] - expected.rgba[i]), 1);
        if (part.rgba[i] != expected.rgba[i]) ++rounded;
    }
    EXPECT_LT(rounded, part.rgba.size() / 10000);
}

TEST_F(WindowInMemory, IsDrawnWhereItHasChangedAsIfItWereDrawnAnew) {
    WindowImage followed(context_->gl());
    MeshImage image(context_->gl());
    std::optional<MeshesToDraw> drawn;
    const auto draw = [&](WindowImage& to) {
        const MeshesToDraw what = meshes();
        to.resize(900, 640, what.theme.background);
        if (what != drawn) image.draw(what), to.take(image, what.area); // as the window does
        drawn = what;
        return to.draw(pixels);
    };
    draw(followed);
    EXPECT_FALSE(followed.draw(pixels)) << "nothing has changed";
    for (const auto& change : {std::function<void()>([] {
                                   ImGui::GetIO().MousePos = {100, 60};
                               }),
                               std::function<void()>([] {
                                   ImGui::GetIO().MousePos = {700, 400};
                               }),
                               std::function<void()>([this] { view().set("blend", 0.3); }),
                               std::function<void()>([this] { application_.perform("sidebar"); }),
                               std::function<void()>([this] { application_.perform("help"); }),
                               std::function<void()>([this] { application_.perform("help"); })}) {
        change();
        EXPECT_TRUE(draw(followed));
        const Image in_parts = followed.read();
        followed.draw_all_anew();
        EXPECT_TRUE(followed.draw(pixels));
        EXPECT_EQ(in_parts.rgba, followed.read().rgba);
    }
}

/// Counts the images of a painter, and waits for them.
class Arrivals {
  public:
    void note() {
        const std::lock_guard lock(mutex_);
        ++count_;
        changed_.notify_all();
    }
    void wait_for(int count) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return count_ >= count; });
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int count_ = 0;
};

TEST_F(WindowInMemory, GetsTheSameMeshesFromAnotherThread) {
    MeshImage image(context_->gl());
    MeshesToDraw what = meshes();
    image.draw(what);
    Arrivals arrivals;
    MeshPainter painter([&] { arrivals.note(); });
    const auto number = painter.want(what, Hurry::in_full);
    ASSERT_TRUE(painter.wait(60));
    const auto painted = painter.take();
    ASSERT_NE(painted, nullptr);
    EXPECT_EQ(painted->what, what);
    EXPECT_TRUE(painted->in_full);
    EXPECT_EQ(painted->number, number);
    EXPECT_EQ(painted->image.rgba, image.image().read().rgba);
    EXPECT_EQ(painter.take(), nullptr) << "taken";

    EXPECT_EQ(painter.want(what, Hurry::at_once), number) << "what is shown";
    view().set("blend", 0.5);
    what = meshes();
    EXPECT_GT(painter.want(what, Hurry::none), number);
    arrivals.wait_for(2); // though nobody is in a hurry
    image.draw(what);
    painter.want(what, Hurry::in_full);
    ASSERT_TRUE(painter.wait(60));
    EXPECT_EQ(painter.take()->image.rgba, image.image().read().rgba);
}

TEST_F(WindowInMemory, MeshesOfSomethingElseAreNotShownInTheirPlace) {
    const MeshesToDraw before = meshes();
    view().set("blend", 0.5);
    EXPECT_TRUE(in_same_place(before, meshes())) << "the same mesh, which has moved";
    for (const char* action : {"sidebar", "theme"}) {
        application_.perform(action);
        meshes(); // a size is known one frame later
        EXPECT_FALSE(in_same_place(before, meshes())) << action;
        application_.perform(action);
        meshes();
        EXPECT_TRUE(in_same_place(before, meshes())) << action;
    }
    view().set("layout", std::string("side-by-side"));
    EXPECT_FALSE(in_same_place(before, meshes()));
    MeshesToDraw moved = before;
    moved.views[0].rectangle.right -= 1;
    EXPECT_FALSE(in_same_place(before, moved)) << "within the same area";
    MeshesToDraw other = before;
    Mesh coarse = *before.views[0].scene.mesh;
    coarse.cells.resize(coarse.cells.size() / 2);
    other.views[0].scene.mesh = std::make_shared<const Mesh>(std::move(coarse));
    EXPECT_FALSE(in_same_place(before, other)) << "another number of cells";
    MeshesToDraw none = before;
    none.views.clear();
    EXPECT_FALSE(in_same_place(before, none));
}

TEST_F(WindowInMemory, SaysWhatThePainterCannotDo) {
    MeshPainter painter([] {});
    MeshesToDraw what = meshes();
    what.area = {0, 0, 1000000, 1000000};
    painter.want(what, Hurry::in_full);
    ASSERT_TRUE(painter.wait(60));
    EXPECT_THROW(painter.want(what, Hurry::none), MachineError);
}

} // namespace
} // namespace gaspard
