#include "gui/application_fixture.hpp"

namespace gaspard {
namespace {

TEST_F(ApplicationTest, ALineAcrossTheMeshIsDraggedAndPlotted) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    ui.click(application.items().find("plot.second.quantity")->second, drawing());
    frame();
    ASSERT_TRUE(application.items().contains("plot.second.quantity=section"));
    ui.click(application.items().find("plot.second.quantity=section")->second, drawing());
    frame(), frame();
    EXPECT_EQ(look().text("section"), "0 0.5 1 0.5") << "through the middle";
    ASSERT_TRUE(application.items().contains("section.1"));

    const std::string camera = look().text("camera");
    const ItemRectangle end = application.items().find("section.1")->second;
    ui.move(end.left, end.top), frame();
    ui.button(true), frame();
    ui.move(end.left - 60, end.top - 40), frame();
    ui.button(false), frame();
    frame();
    const auto line = parse_section_line(look().text("section"));
    ASSERT_TRUE(line);
    EXPECT_EQ(line->from, (Vec3{0, 0.5, 0})) << "the other end stays";
    EXPECT_LT(line->to.x, 1);
    EXPECT_GT(line->to.y, 0.5);
    EXPECT_EQ(look().text("camera"), camera) << "the mesh stays";
    EXPECT_TRUE(look().text("pick").empty());

    const ItemRectangle moved = application.items().find("section.1")->second;
    EXPECT_NEAR(moved.left, end.left - 60, 1.5F);
    EXPECT_NEAR(moved.top, end.top - 40, 1.5F);
    look().set("section", std::string("0 0.5 1"));
    for (int i = 0; i < 3; ++i) frame(); // a line that cannot be read is a complaint, no end
}

TEST_F(ApplicationTest, AShownSectionLeavesUndoAlone) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 15.0);
    application.document().change(run().id, changed);
    ui.click(application.items().find("plot.second.quantity")->second, drawing());
    frame();
    ui.click(application.items().find("plot.second.quantity=section")->second, drawing());
    for (int i = 0; i < 3; ++i) frame();
    for (int i = 0; i < 2; ++i) application.press_key("Ctrl+Z"), frame(), frame();
    EXPECT_EQ(look().text("section"), "") << "it is not drawn again";
    EXPECT_EQ(run().scenario.monitor.values.real("amplitude"), 10);
    EXPECT_TRUE(application.document().edits().can_redo());
}

} // namespace
} // namespace gaspard
