// Several methods on one problem in the window: solved one after the other, seen together.
#include "core/tessellate/ticks.hpp"
#include "gui/application_fixture.hpp"
#include "gui/panels/plot_choice.hpp"
#include "gui/panels/status_bar.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {
namespace {

class CompareTest : public ApplicationTest {
  protected:
    ItemRectangle item(const std::string& key) {
        frame();
        const auto found = application.items().find(key);
        EXPECT_NE(found, application.items().end()) << key;
        return found == application.items().end() ? ItemRectangle{} : found->second;
    }
    void begin() {
        ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
        EXPECT_TRUE(application.press_key("C"));
        frame(); // it finds its size
        ui.click(item("compare.begin"), drawing());
    }
};

TEST_F(CompareTest, EveryMethodSolvesTheProblemAndAllAreSeenTogether) {
    begin();
    std::size_t most_live = 0;
    ASSERT_TRUE(wait_until([&] {
        const auto& runs = application.document().runs();
        const auto live = static_cast<std::size_t>(
            std::count_if(runs.begin(), runs.end(), [](const DocumentRun& one) { return one.live(); }));
        most_live = std::max(most_live, live);
        return !application.document().comparison().running();
    }));
    EXPECT_LE(most_live, 2U) << "one after the other, beside the window's own";
    const auto rows = application.document().comparison().rows();
    ASSERT_EQ(rows.size(), 5U);
    for (const ComparisonRow& row : rows) {
        EXPECT_EQ(row.status, RunStatus::converged) << row.method;
        EXPECT_NEAR(*row.equidistribution, *rows.front().equidistribution, 1e-6) << row.method;
        EXPECT_GT(row.cpu_seconds, 0) << row.method;
        EXPECT_TRUE(application.items().count("compare.row." + row.method)) << row.method;
    }
    const auto& runs = application.document().runs();
    ASSERT_EQ(runs.size(), 6U);
    EXPECT_EQ(view_of_runs(runs, {}).curves.size(), 6U) << "one plot";
    for (std::size_t i = 1; i < runs.size(); ++i) EXPECT_FALSE(runs[i].live());

    ui.click(item("compare.meshes"), drawing());
    frame();
    ASSERT_EQ(application.views().size(), 6U) << "beside each other";
    for (const ShownView& one : application.views()) {
        EXPECT_EQ(one.camera, application.views().front().camera);
        EXPECT_EQ(size_of(one), size_of(application.views().front()));
    }
    const ItemRectangle centre = item("handle.center_x"), own = shown(0).rectangle;
    EXPECT_TRUE(centre.left > own.left && centre.left < own.right && centre.top < own.bottom)
        << "only the present run's monitor can be moved";
    ui.click(item("compare.copy"), drawing());
    EXPECT_EQ(std::string(ImGui::GetClipboardText()), comparison_csv(rows));

    EXPECT_EQ(application.items().count("compare.other"), 0U);
    Scenario other = run().scenario;
    other.monitor.values.set("amplitude", 3.0);
    application.document().change(run().id, other);
    frame();
    EXPECT_EQ(application.items().count("compare.other"), 1U) << "the table says what it is for";
    application.document().undo();
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_EQ(application.items().count("compare.other"), 0U);

    application.press_key("Escape"); // the panel is closed
    frame();
    const ItemRectangle second = application.views()[1].rectangle;
    ui.drag(second, 0.5F, 0.7F, drawing());
    frame();
    EXPECT_EQ(application.views()[5].camera, application.views()[0].camera) << "they move together";
    application.document().hide(runs[2].id, true);
    frame();
    EXPECT_EQ(application.views().size(), 5U) << "a hidden run is not shown";
    application.document().hide(runs[0].id, true); // the window's own
    frame();
    ASSERT_EQ(application.views().size(), 4U);
    EXPECT_EQ(application.items().count("handle.center_x"), 0U);
    for (std::size_t i = 1; i < runs.size(); ++i) application.document().hide(runs[i].id, true);
    frame();
    EXPECT_EQ(application.views().size(), 1U) << "all are hidden: the present one";
    for (std::size_t i = 0; i < runs.size(); ++i) application.document().hide(runs[i].id, false);

    EXPECT_TRUE(application.press_key("V"));
    frame();
    EXPECT_EQ(application.views().size(), 1U);
}

TEST_F(CompareTest, ThePanelLeavesTheMeshInSight) {
    for (const ImVec2 size : {ImVec2(1400, 900), ImVec2(1000, 700)}) {
        ImGui::GetIO().DisplaySize = size;
        begin();
        ASSERT_TRUE(wait_until([&] { return !application.document().comparison().running(); }));
        frame(), frame();
        const ItemRectangle panel = item("compare"), view = application.viewport_rectangle();
        EXPECT_GE(panel.left, view.left + 0.6F * view.width()) << size.x;
        EXPECT_LE(panel.right, size.x) << size.x;
        EXPECT_LE(panel.bottom, size.y) << size.x;
        application.press_key("Escape");
        frame();
    }
}

TEST_F(CompareTest, OnlyTickedMethodsAndOnlyOnce) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    application.press_key("C");
    frame();
    for (const char* method : {"quasi-newton", "relaxation", "accelerated"})
        ui.click(item("compare." + std::string(method)), drawing());
    for (int time = 0; time < 2; ++time) {
        ui.click(item("compare.begin"), drawing());
        ASSERT_TRUE(wait_until([&] { return !application.document().comparison().running(); }));
        const auto rows = application.document().comparison().rows();
        ASSERT_EQ(rows.size(), 2U);
        EXPECT_EQ(rows[0].method, "newton");
        EXPECT_EQ(rows[1].method, "auto");
        EXPECT_EQ(application.document().runs().size(), 3U) << "the comparison before has gone";
    }
}

TEST_F(CompareTest, IsCancelledAndTheRunGoesOn) {
    set_value(*catalogue, run().scenario, "method.tolerance", 1e-14); // not within the test
    set_value(*catalogue, run().scenario, "method.max_iterations", std::int64_t{1000000});
    set_value(*catalogue, run().scenario, "method.step_size", 1e-4);
    application.document().change(run().id, Scenario(run().scenario));
    ASSERT_TRUE(wait_until([&] { return run().solving() && run().changes.settled(); }));
    application.document().compare({"relaxation", "newton"});
    EXPECT_FALSE(run().solving()) << "it waits";
    ASSERT_TRUE(wait_until([&] {
        return application.document().runs().size() == 2 &&
               application.document().runs()[1].history.size() > 3;
    }));
    EXPECT_EQ(application.items().count("progress"), 1U) << "also where the panel is closed";
    EXPECT_TRUE(application.press_key("Escape"));
    EXPECT_FALSE(application.document().comparison().running());
    const auto rows = application.document().comparison().rows();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].status, RunStatus::interrupted);
    EXPECT_TRUE(wait_until([&] { return run().solving(); }));
}

TEST_F(CompareTest, AMethodThatCannotBeginSaysSo) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    run().scenario = find_scenario(*catalogue, "spline-circle");
    run().scenario.domain = domain_section(*catalogue, "spline-patch");
    run().scenario.domain.values.set("file", std::string("gone.json")); // since the run has read it
    application.document().compare({"picard"});
    ASSERT_TRUE(wait_until([&] { return !application.document().comparison().running(); }));
    const auto rows = application.document().comparison().rows();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].status, RunStatus::failed);
    ASSERT_FALSE(application.messages().log().lines().empty());
    const auto& lines = application.messages().log().lines();
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const LogLine& line) {
        return line.notice.error && line.notice.text.find("gone.json") != std::string::npos;
    })) << application.messages().log().text();
    EXPECT_FALSE(application.messages().error().open()) << "the present run is none the worse";
}

TEST_F(CompareTest, SplinesHaveOneMeasureAndPicardItsOwnByName) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    run().scenario = find_scenario(*catalogue, "spline-circle");
    set_value(*catalogue, run().scenario, "domain.cells", std::int64_t{16});
    application.document().compare({"picard", "newton"});
    ASSERT_TRUE(wait_until([&] { return !application.document().comparison().running(); }));
    const auto rows = application.document().comparison().rows();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].criterion, "increment");
    EXPECT_LT(rows[0].criterion_value, 1e-8);
    EXPECT_GT(rows[0].residual, 1e-7) << "by which Picard's iteration is not there yet";
    EXPECT_EQ(rows[1].criterion, "residual");
    EXPECT_LT(rows[1].residual, 1e-8);
    const auto cells = status_cells(application.document().runs()[1]);
    EXPECT_EQ(cells[2].label, "Residual");
    EXPECT_EQ(cells[3].label, "Increment");
    EXPECT_EQ(cells[3].value, short_number(rows[0].criterion_value));
}

TEST_F(CompareTest, ShippedScenariosOpenWithTheMethodThatChooses) {
    const Scenario opened = for_window(*catalogue, find_scenario(*catalogue, "plane-bell"));
    EXPECT_EQ(opened.method.type, "auto");
    EXPECT_EQ(opened.method.values.real("tolerance"), 1e-8);
    EXPECT_EQ(find_scenario(*catalogue, "plane-bell").method.type, "relaxation") << "pinned elsewhere";
    application.document().replace(run().id, for_window(*catalogue, small_ring()));
    EXPECT_TRUE(wait_until([&] { return run().openings == 1 && run().ended(); }));
    EXPECT_NE(method_note(run(), *catalogue).find("Automatic"), std::string::npos)
        << "and what it does is said";
}

} // namespace
} // namespace gaspard
