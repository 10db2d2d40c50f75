#include "gui/application_fixture.hpp"

#include <algorithm>

namespace gaspard {
namespace {

class ReplayTest : public ApplicationTest {
  protected:
    void SetUp() override {
        ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    }
    ColourRange range() {
        frame();
        return shown().scene.colouring->range;
    }
    void colour_by(const std::string& name) { look().set("color", name); }
};

TEST_F(ReplayTest, OneRangeOfColoursHoldsOverTheWholeSolve) {
    for (const char* name : {"area", "displacement", "equidistribution"}) {
        colour_by(name);
        const ColourRange newest = range();
        application.perform("to-start");
        const ColourRange held = range();
        EXPECT_LE(held.low, newest.low) << name;
        EXPECT_GE(held.high, newest.high) << name;
        const auto& values = shown().scene.colouring->values;
        EXPECT_GE(*std::min_element(values.begin(), values.end()), held.low)
            << name << ", of the start as well";
        EXPECT_LE(*std::max_element(values.begin(), values.end()), held.high) << name;
        while (application.status()[1].value != std::to_string(run().history.back().iteration)) {
            application.perform("step");
            EXPECT_EQ(range(), held) << name << ", iteration " << application.status()[1].value;
        }
        application.perform("to-end"); // fits it again
        EXPECT_EQ(range(), newest) << name;
    }
}

TEST_F(ReplayTest, AFixedRangeStaysAndTheViewKeepsItsOwn) {
    colour_by("area");
    application.perform("to-start");
    range();
    EXPECT_EQ(look().text("range"), "automatic");
    EXPECT_EQ(application.document().edits().undo_count(), 1U) << "only the choice of colours";
    look().set("range", std::string("fixed"));
    look().set("low", 0.001), look().set("high", 0.002);
    EXPECT_EQ(range(), (ColourRange{0.001, 0.002}));
}

TEST_F(ReplayTest, AnotherSolveFitsTheColoursAgain) {
    colour_by("equidistribution");
    const ColourRange newest = range();
    application.perform("to-start");
    EXPECT_NE(range(), newest) << "the start deviates more";
    const auto before = run().histories;
    application.perform("run-again");
    ASSERT_TRUE(wait_until([&] { return run().histories > before && run().ended(); }));
    EXPECT_EQ(range(), newest);
}

TEST_F(ReplayTest, TheBarSpansTheLongestOfTheRunsThatAreShown) {
    const int longest = run().history.back().iteration;
    application.perform("keep");
    Scenario shorter = run().scenario;
    set_value(*catalogue, shorter, "method.max_iterations", std::int64_t{3});
    application.document().change(run().id, shorter);
    application.perform("run-again");
    ASSERT_TRUE(wait_until(
        [&] { return run().changes.settled() && run().ended() && run().history.back().iteration == 3; }));
    const auto middle_of_bar = [&] {
        frame();
        const ItemRectangle bar = application.items().find("playback.scrubber")->second;
        ui.click({bar.center_x(), bar.top, bar.center_x(), bar.bottom}, drawing());
        frame();
        return shown(application.views().size() - 1).scene;
    };
    middle_of_bar();
    EXPECT_LE(std::stoi(application.status()[1].value), 2) << "alone, its own iterations";
    application.perform("runs");
    frame();
    ASSERT_EQ(application.views().size(), 2U);
    middle_of_bar();
    EXPECT_EQ(application.status()[1].value, "3") << "the shorter one stays at its end";
    application.perform("step-back");
    frame();
    EXPECT_GT(longest, 6);
    EXPECT_EQ(application.status()[1].value, "3");
}

TEST_F(ReplayTest, ANarrowBarHasTheRestOfItsButtonsInAMenu) {
    ImGui::GetIO().DisplaySize = {25 * ImGui::GetFontSize(), 19 * ImGui::GetFontSize()};
    application.perform("sidebar");
    frame(), frame();
    ASSERT_TRUE(application.items().contains("playback.more"));
    EXPECT_FALSE(application.items().contains("action.loop"));
    EXPECT_TRUE(application.items().contains("plots.note")) << "and says why there are no plots";
    EXPECT_FALSE(application.items().contains("plot.first"));
    ui.click(application.items().find("playback.more")->second, drawing());
    frame();
    for (const char* name : {"action.step-back", "action.to-start", "action.loop", "action.blend-loop"})
        EXPECT_TRUE(application.items().contains(name)) << name;
}

} // namespace
} // namespace gaspard
