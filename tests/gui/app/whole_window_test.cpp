// The picture of the window: what is drawn quickly, kept, and drawn in full later.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "gui/app/whole_window.hpp"
#include "gui/gl/imgui_context.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

FinishedRun small_run(const std::shared_ptr<const Catalogue>& catalogue) {
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario, {"domain.cells=12"});
    gaspard::Run run(catalogue, scenario);
    run.solve();
    return {scenario, run.history(), run.snapshot()};
}

TEST(WindowImage, DrawsQuicklyWhileItMovesAndInFullOnceItRests) {
    const auto context = make_offscreen_context(OffscreenBackend::any);
    const ImGuiSession session;
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Application application(catalogue, small_run(catalogue));
    ImGui::GetIO().DisplaySize = {900, 640};
    load_font(*ImGui::GetIO().Fonts, dark_theme(), 1);
    apply_theme(dark_theme(), 1);
    WindowImage image(context->gl()), other(context->gl());
    const auto draw = [&](WindowImage& to, const Drawing& drawing) {
        for (int i = 0; i < 2; ++i) {
            ImGui::NewFrame();
            application.frame();
            ImGui::Render();
        }
        return to.draw(application, {900, 640, 1}, 1, drawing);
    };
    Values& view = application.document().viewports().front().view;
    auto outcome = draw(image, {});
    EXPECT_TRUE(outcome.anew && outcome.complete);
    view.set("blend", 0.5);
    outcome = draw(image, {.quickly = true, .finish = false});
    EXPECT_TRUE(outcome.anew && !outcome.complete);
    outcome = draw(image, {.quickly = true, .finish = false});
    EXPECT_TRUE(!outcome.anew && !outcome.complete) << "nothing has changed, nor has it rested";
    const Image quick = image.read();
    outcome = draw(image, {.quickly = true});
    EXPECT_TRUE(outcome.anew && outcome.complete);
    const Image full = image.read();
    EXPECT_NE(full.rgba, quick.rgba) << "with several samples a pixel";
    draw(other, {});
    EXPECT_EQ(other.read().rgba, full.rgba) << "as if it had never been drawn quickly";

    view.set("lines", false); // seen from the same place
    outcome = draw(image, {.quickly = true, .keep = true});
    EXPECT_TRUE(!outcome.anew && !outcome.complete);
    outcome = draw(image, {.quickly = true});
    EXPECT_TRUE(outcome.anew) << "in the next frame";
    view.set("blend", 1.0);
    EXPECT_TRUE(draw(image, {.quickly = true, .keep = true}).anew) << "what the hand moves is not kept";
}

} // namespace
} // namespace gaspard
