// A method's own series and fields (fixtures/springs.hpp) in the window: plots, colours and numbers offer
// them by their names, which nothing in src knows.
#include "fixtures/fixture_catalogue.hpp"
#include "gui/application_fixture.hpp"
#include "gui/document/runs_csv.hpp"
#include "gui/panels/plot_choice.hpp"
#include "gui/panels/status_bar.hpp"

namespace gaspard {
namespace {

class SpringsApplicationTest : public ApplicationFixture {
  protected:
    SpringsApplicationTest() : SpringsApplicationTest(std::make_shared<Catalogue>(fixture_catalogue())) {}
    bool there(const std::string& key) { return application.items().find(key) != application.items().end(); }
    void click(const std::string& key) {
        ASSERT_TRUE(there(key)) << key;
        ui.click(application.items().find(key)->second, drawing());
        frame();
    }

  private:
    explicit SpringsApplicationTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, springs(*of)) {}
    static Scenario springs(const Catalogue& catalogue) {
        Scenario scenario = default_scenario(catalogue);
        apply_settings(catalogue, scenario,
                       {"domain.type=disk", "domain.cells=4", "monitor.type=band", "method.type=springs",
                        "method.max_iterations=40", "view.color=force"});
        return scenario;
    }
};

TEST_F(SpringsApplicationTest, PlotsShowTheMethodsSeries) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    frame();
    click("plot.first.quantity");
    for (const char* name : {"residual", "equidistribution", "jacobian", "step-size", "energy",
                             "largest-force", "largest-strain"})
        EXPECT_TRUE(there("plot.first.quantity=" + std::string(name))) << name;
    EXPECT_FALSE(there("plot.first.quantity=theta")) << "that of other methods";
    click("plot.first.quantity=energy");
    frame();
    const auto words = parse_choice(application.settings().window.text("first_plot"));
    ASSERT_TRUE(words);
    EXPECT_EQ(*words, (PlotChoice{.plot = "energy", .log_y = false})) << "on the axis that the series says";
    const PlotView view = view_of_runs(application.document().runs(), *words);
    ASSERT_EQ(view.curves.size(), 1U);
    ASSERT_EQ(view.curves[0].y.size(), run().history.size());
    EXPECT_EQ(view.curves[0].y.back(), run().history.back().value("energy"));
    EXPECT_EQ(view.y.label, "E [J]");
    EXPECT_EQ(plot_label(application.document().runs(), "energy"), "Spring energy");
}

TEST_F(SpringsApplicationTest, NumbersOfRunsHaveThem) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const std::string csv = runs_csv(application.document().runs());
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "run,iteration,seconds,residual,equidistribution,min_jacobian,max_jacobian,step_size,"
              "tangled_cells,energy,largest_force,largest_strain");
    EXPECT_EQ(status_cells(run())[2].label, "Relative force");
}

TEST_F(SpringsApplicationTest, ColoursAreThoseOfTheMethodAsLongAsItIsChosen) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    click("view.color");
    ASSERT_TRUE(there("view.color=force"));
    click("view.color=strain");
    EXPECT_EQ(look().text("color"), "strain");
    ASSERT_TRUE(wait_until([&] {
        return !application.views().empty() && shown().scene.colouring &&
               shown().scene.colouring->name == "strain";
    }));
    EXPECT_EQ(shown().scene.colouring->label, "Strain [%]");
    Scenario other = run().scenario;
    apply_settings(*catalogue, other, {"method.type=relaxation", "monitor.type=bell"});
    application.document().change(run().id, other);
    ASSERT_TRUE(wait_until([&] { return look().text("color") == "monitor"; }));
    // What the panel says of the mesh moves the rows below it.
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    frame();
    click("view.color");
    EXPECT_TRUE(there("view.color=area"));
    EXPECT_FALSE(there("view.color=strain"));
    EXPECT_FALSE(there("view.color.reset")) << "what it was opened with is no colour here";
}

TEST_F(SpringsApplicationTest, UndoOfAnotherMethodRestoresTheFieldToColourBy) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    look().set("color", std::string("strain"));
    frame();
    const EditHistory& edits = application.document().edits();
    ASSERT_EQ(edits.undo_count(), 1U);
    Scenario other = run().scenario;
    apply_settings(*catalogue, other, {"method.type=relaxation", "monitor.type=bell"});
    application.document().change(run().id, other);
    EXPECT_EQ(look().text("color"), "monitor") << "the method has no such field";
    frame(), frame();
    EXPECT_EQ(edits.undo_count(), 2U) << "the method and the colour are one edit";
    EXPECT_EQ(edits.undo_label(), "monitor type, method type");
    application.press_key("Ctrl+Z");
    EXPECT_EQ(look().text("color"), "strain");
    frame(), frame();
    EXPECT_TRUE(edits.can_redo());
    application.press_key("Ctrl+Z");
    EXPECT_EQ(look().text("color"), "force");
    application.press_key("Ctrl+Y");
    EXPECT_EQ(look().text("color"), "strain");
    EXPECT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().status.scenario->method.type, "springs");
}

} // namespace
} // namespace gaspard
