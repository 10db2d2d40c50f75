#include "gui/application_fixture.hpp"

#include <imgui_internal.h> // the names of draw lists

namespace gaspard {
namespace {

TEST_F(ApplicationTest, TheSizeForProjectorsHidesThePanelAndRestoresIt) {
    const auto panel = [&] { return find_action(application.actions(), "sidebar").is_checked(); };
    ASSERT_TRUE(panel());
    application.press_key("F10");
    EXPECT_FALSE(panel());
    application.press_key("F10");
    EXPECT_TRUE(panel());
    application.press_key("F2");
    application.press_key("F10");
    application.press_key("F10");
    EXPECT_FALSE(panel()) << "it was hidden before";
}

TEST_F(ApplicationTest, ASmallWindowShowsTheMeshAloneWithoutOverlaps) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    const auto resize = [&](float width, float height) {
        ImGui::GetIO().DisplaySize = {width, height};
        for (int i = 0; i < 3; ++i) frame();
    };
    const auto shows = [&](const char* item) { return application.items().count(item) == 1; };
    resize(1400, 900);
    EXPECT_TRUE(shows("monitor.as-formula"));
    resize(ImGui::GetFontSize() * 31, 380);
    EXPECT_TRUE(shows("monitor.type"));
    EXPECT_FALSE(shows("monitor.as-formula")) << "its button would cover the heading";
    resize(ImGui::GetFontSize() * 21, 240);
    EXPECT_FALSE(shows("monitor.type")) << "the panel is left out";
    EXPECT_EQ(application.viewport_rectangle().left, 0);
    EXPECT_GT(shown().rectangle.height(), 4 * ImGui::GetFontSize());
    for (const auto& [width, height] : {std::pair{60.0F, 40.0F}, {1.0F, 1.0F}, {3000.0F, 20.0F}})
        resize(width, height); // nothing is thrown
    resize(1400, 900);
    EXPECT_TRUE(shows("monitor.type"));
}

TEST_F(ApplicationTest, AxesStayWithTheMeshThatIsOnTheScreen) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    const auto drawn = [&] { // the axes are drawn first, the handles last: only the former are compared
        std::vector<ImVec2> corners;
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i)
            if (std::string(data.CmdLists[i]->_OwnerName) == "##viewport")
                for (int k = 0; k < std::min(400, data.CmdLists[i]->VtxBuffer.Size); ++k)
                    corners.push_back(data.CmdLists[i]->VtxBuffer[k].pos);
        return corners;
    };
    const auto same = [](const std::vector<ImVec2>& one, const std::vector<ImVec2>& other) {
        return one.size() == other.size() &&
               std::equal(one.begin(), one.end(), other.begin(),
                          [](ImVec2 a, ImVec2 b) { return a.x == b.x && a.y == b.y; });
    };
    frame();
    const std::vector<ImVec2> before = drawn();
    ASSERT_FALSE(before.empty());
    const std::vector<ShownView> painted = application.views();
    look().set("camera", std::string("centre 0.5 0.4 height 1.7"));
    application.stay_with(painted);
    frame();
    EXPECT_FALSE(application.views().front().camera == painted.front().camera);
    EXPECT_TRUE(same(drawn(), before)) << "the mesh of the new camera is not there yet";
    application.stay_with({});
    frame();
    EXPECT_FALSE(same(drawn(), before));
}

TEST_F(ApplicationTest, TheMouseSteersTheCamera) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    application.press_key("H"); // for the mesh as it now stands
    frame();
    const ItemRectangle view = application.items().find("viewport")->second;
    const Size size{static_cast<double>(view.width()), static_cast<double>(view.height())};
    const Camera home = application.views().front().camera;

    ui.drag(view, 0.5F, 0.6F, drawing());
    const Pixel moved = to_pixel(application.views().front().camera, size, home.centre);
    EXPECT_NEAR(moved.x, 0.6 * size.width, 2) << "the mesh follows the mouse";
    EXPECT_NEAR(moved.y, 0.5 * size.height, 2);

    const Pixel pointer{std::floor(0.25 * size.width), std::floor(0.75 * size.height)};
    ui.move(view.left + static_cast<float>(pointer.x), view.top + static_cast<float>(pointer.y));
    frame();
    const Camera before = application.views().front().camera;
    ui.wheel(3);
    frame();
    EXPECT_LT(application.views().front().camera.scale, before.scale);
    const Vec3 there = to_world(before, size, pointer),
               now = to_world(application.views().front().camera, size, pointer);
    EXPECT_NEAR(there.x, now.x, 1e-6) << "what is under the pointer stays there";
    EXPECT_NEAR(there.y, now.y, 1e-6);

    EXPECT_TRUE(application.press_key("H"));
    frame();
    EXPECT_EQ(application.views().front().camera, home);
    ui.drag(view, 0.5F, 0.6F, drawing());
    EXPECT_NE(application.views().front().camera, home);
    for (int i = 0; i < 30; ++i) frame(); // so that the drag is not the first of two clicks
    const Camera dragged = application.views().front().camera;
    ItemRectangle corner = view; // clicked at its middle
    corner.right = view.left + 0.6F * view.width();
    corner.bottom = view.top + 0.6F * view.height();
    ui.click(corner, drawing());
    EXPECT_NE(application.document().viewports()[0].view.text("pick"), "") << "a click picks";
    EXPECT_EQ(application.views().front().camera, dragged);
    ui.click(corner, drawing());
    frame();
    const Vec3 clicked = to_world(dragged, size, {0.3 * size.width, 0.3 * size.height});
    const Pixel middle = to_pixel(application.views().front().camera, size, clicked);
    EXPECT_NEAR(middle.x, size.width / 2, 1) << "a double click brings a point to the middle";
    EXPECT_NEAR(middle.y, size.height / 2, 1);
    EXPECT_EQ(application.document().viewports()[0].view.text("pick"), "") << "and picks nothing";
}

TEST_F(ApplicationTest, ADragBetweenTwoFramesIsADragAndNoClick) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    frame();
    const ItemRectangle view = application.items().find("viewport")->second;
    const Camera before = shown().camera;
    const float x = std::floor(view.center_x()), y = std::floor(view.center_y());
    ui.move(x, y);
    frame();
    ui.button(true);
    frame();
    ui.move(x + 40, y - 30); // and the button comes up before the next frame
    ui.button(false);
    frame();
    frame();
    EXPECT_EQ(look().text("pick"), "");
    const Pixel moved = to_pixel(shown().camera, size_of(shown()), before.centre);
    EXPECT_NEAR(moved.x, size_of(shown()).width / 2 + 40, 1e-6);
    EXPECT_NEAR(moved.y, size_of(shown()).height / 2 - 30, 1e-6);
}

TEST_F(ApplicationTest, AnotherDomainHasOtherCellsSoThePickEnds) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    look().set("pick", std::string("cell 7"));
    frame();
    ui.drag(application.items().find("monitor.amplitude")->second, 0.5F, 0.55F, drawing());
    EXPECT_EQ(look().text("pick"), "cell 7") << "the same cells";
    ui.drag(application.items().find("domain.cells")->second, 0.3F, 0.4F, drawing());
    EXPECT_EQ(look().text("pick"), "");
}

TEST_F(ApplicationTest, TheCameraIsCopiedAndPastedAsText) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    application.press_key("H");
    frame();
    const Camera home = application.views().front().camera;
    EXPECT_TRUE(application.press_key("Ctrl+C"));
    const std::string copied = ImGui::GetClipboardText();
    ui.drag(application.items().find("viewport")->second, 0.5F, 0.6F, drawing());
    EXPECT_NE(application.views().front().camera, home);
    EXPECT_TRUE(application.press_key("Ctrl+V"));
    frame();
    EXPECT_EQ(application.views().front().camera.centre, home.centre);
    EXPECT_EQ(application.document().viewports()[0].view.text("camera"), copied);
    ImGui::SetClipboardText("milk, bread");
    EXPECT_TRUE(application.press_key("Ctrl+V"));
    EXPECT_NE(application.messages().last().text.find("the camera 'milk, bread'"), std::string::npos);
    EXPECT_EQ(application.document().viewports()[0].view.text("camera"), copied) << "nothing is lost";
}

TEST_F(ApplicationTest, EscapeEndsThePickAndNotTheSolving) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3 && !application.views().empty(); }));
    ui.click(application.items().find("viewport")->second, drawing());
    const Values& values = application.document().viewports()[0].view;
    EXPECT_NE(values.text("pick"), "");
    EXPECT_TRUE(application.press_key("Escape"));
    EXPECT_EQ(values.text("pick"), "");
}

TEST_F(ApplicationTest, TheViewIsSwitchedByKeys) {
    ASSERT_TRUE(wait_until([&] { return !application.views().empty(); }));
    const Values& values = application.document().viewports()[0].view;
    EXPECT_TRUE(application.press_key("B"));
    frame();
    EXPECT_EQ(application.views().size(), 2U);
    EXPECT_TRUE(application.press_key("B"));
    EXPECT_TRUE(application.press_key("L"));
    EXPECT_TRUE(application.press_key("A"));
    frame();
    EXPECT_EQ(application.views().size(), 1U);
    EXPECT_FALSE(application.views()[0].scene.lines);
    EXPECT_NE(application.views()[0].scene.arrows, nullptr);
    EXPECT_FALSE(application.press_key("3")) << "a plane has one side";
    EXPECT_EQ(values.text("direction"), "home");
}

TEST_F(ApplicationTest, AFixedRangeBeginsAsWhatIsSeen) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    const ColourRange seen = application.views()[0].scene.colouring->range;
    ui.click(application.items().find("view.range")->second, drawing());
    frame();
    ui.click(application.items().find("view.range=fixed")->second, drawing());
    frame();
    const Values& values = application.document().viewports()[0].view;
    EXPECT_EQ(values.text("range"), "fixed");
    EXPECT_EQ(values.real("low"), seen.low);
    EXPECT_EQ(values.real("high"), seen.high);
    EXPECT_EQ(application.views()[0].scene.colouring->range, seen);
}

TEST_F(ApplicationTest, BlendShowsTheComputationalMeshAndSolvesNothing) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto rows = run().history.size();
    EXPECT_EQ(application.views().front().scene.blend, 1);
    ui.drag(application.items().find("view.blend")->second, 0.9F, -0.5F, drawing());
    frame();
    EXPECT_EQ(application.views().front().scene.blend, 0);
    solved_scenario();
    EXPECT_EQ(run().history.size(), rows);
}

} // namespace
} // namespace gaspard
