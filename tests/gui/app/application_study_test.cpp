// The plot of an error study: it fills while the window goes on, and a drag across it sets a parameter.
#include "gui/application_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace gaspard {
namespace {

class ErrorStudyTest : public ApplicationFixture {
  protected:
    ErrorStudyTest() : ErrorStudyTest(std::make_shared<Catalogue>(builtin_catalogue())) {}
    const ErrorStudy& study(std::size_t place = 0) { return application.error_plots().study(place); }
    bool there(const std::string& key) { return application.items().find(key) != application.items().end(); }
    void click(const std::string& key) {
        ASSERT_TRUE(there(key)) << key;
        ui.click(application.items().find(key)->second, drawing());
        frame();
    }
    void choose(const std::string& abscissa = "cells") {
        ASSERT_TRUE(wait_until([&] { return run().ended() && run().changes.settled(); }));
        click("plot.first.quantity");
        click("plot.first.quantity=error-study");
        if (abscissa == "cells") return;
        click("plot.first.menu");
        click("plot.first.menu." + abscissa);
    }
    bool finished() {
        return wait_until([&] { return study().current() && study().result().done; });
    }
    Plot plot() { return application.error_plots().plots(run(), choices()).front(); }
    ErrorPlots::Choices choices() {
        const std::string text = application.settings().window.text("first_plot");
        return {parse_choice(text).value_or(PlotChoice{}), PlotChoice{}};
    }
    const Curve& now(const Plot& of) { return of.curves.back(); }

  private:
    explicit ErrorStudyTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, find_scenario(*of, "layer-1d")) {}
};

TEST_F(ErrorStudyTest, ItFillsWithTheErrorsOfOtherRunsOfThisProblem) {
    choose();
    EXPECT_EQ(application.settings().window.text("first_plot"), "error-study,cells,log,log");
    ASSERT_TRUE(wait_until([&] { return !study().result().points.empty(); }));
    frame();
    ASSERT_TRUE(finished());
    const auto points = study().result().points;
    ASSERT_EQ(points.size(), 40U);
    EXPECT_EQ(plot().title, "") << "nothing is missing";
    for (const auto& [eps, line] : {std::pair{"pde.eps=1", 0U}, {"pde.eps=1e-8", 4U}}) {
        Scenario scenario = run().scenario;
        apply_settings(*catalogue, scenario, {eps, "domain.cells=128"});
        gaspard::Run other(catalogue, scenario);
        other.solve();
        const StudyPoint* point = find_point(points, line, 4);
        ASSERT_TRUE(point);
        EXPECT_EQ(point->x, 128);
        EXPECT_EQ(study_value(*point, "energy_error"), other.history().back().value("energy_error"));
    }
    const Plot shown = plot();
    EXPECT_EQ(now(shown).label, "now");
    EXPECT_EQ(now(shown).x, std::vector<double>{32});
    EXPECT_EQ(now(shown).y.front(), run().history.back().value("energy_error"));
    EXPECT_EQ(shown.curves[2].y[2], now(shown).y.front()) << "on the line of its eps";
    EXPECT_FALSE(shown.marks.back().handle) << "cells are not dragged";
}

TEST_F(ErrorStudyTest, AnotherEpsMovesThePresentPointOnly) {
    choose();
    ASSERT_TRUE(finished());
    const double before = now(plot()).y.front();
    Scenario scenario = run().scenario;
    apply_settings(*catalogue, scenario, {"pde.eps=1e-6"});
    application.document().change(run().id, scenario);
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().changes.settled(); }));
    EXPECT_TRUE(study().current());
    EXPECT_TRUE(study().result().done);
    EXPECT_NEAR(now(plot()).y.front(), before / 10, 0.01 * before);
    apply_settings(*catalogue, scenario, {"monitor.sigma=4"});
    application.document().change(run().id, scenario);
    ASSERT_TRUE(wait_until([&] {
        return study().plan() && study().plan()->scenario.monitor.values.real("sigma") == 4;
    })) << "with the values of the run";
    ASSERT_TRUE(finished());
    EXPECT_EQ(study().result().points.size(), 40U);
}

// As a drag does that ends where it began, before the run rests.
TEST_F(ErrorStudyTest, BeginsAnewWhenTheValuesReturnWhileItIsCancelled) {
    const Scenario scenario = find_scenario(*catalogue, "layer-1d");
    Scenario other = scenario;
    apply_settings(*catalogue, other, {"monitor.sigma=4"});
    ErrorStudy own(catalogue, {});
    const auto points_reach = [&](std::size_t count) {
        return wait_until([&] {
            own.follow(scenario, "cells", true);
            return own.result().points.size() >= count;
        });
    };
    ASSERT_TRUE(points_reach(1));
    own.follow(other, "cells", false);
    EXPECT_FALSE(own.current());
    EXPECT_TRUE(points_reach(40));
    EXPECT_TRUE(own.current());
}

TEST_F(ErrorStudyTest, ADragAcrossItSetsTheParameterAsOneEdit) {
    choose("sigma");
    ASSERT_TRUE(finished());
    frame(), frame();
    EXPECT_EQ(now(plot()).x, std::vector<double>{2.5});
    EXPECT_TRUE(plot().marks.back().handle);
    const EditHistory& edits = application.document().edits();
    const std::size_t before = edits.undo_count();
    ui.drag(application.items().find("plot.first.curves")->second, 0.5F, 0.75F, drawing());
    frame();
    const double sigma = run().scenario.monitor.values.real("sigma");
    EXPECT_GT(sigma, 2.6);
    EXPECT_LT(sigma, 16);
    EXPECT_EQ(edits.undo_count(), before + 1);
    EXPECT_EQ(now(plot()).x, std::vector<double>{sigma});
    EXPECT_TRUE(study().current()) << "sigma is what varies";
    EXPECT_EQ(solved_scenario().monitor.values.real("sigma"), sigma) << "the mesh follows";
    application.press_key("Ctrl+Z");
    EXPECT_EQ(run().scenario.monitor.values.real("sigma"), 2.5);
}

TEST_F(ErrorStudyTest, EpsAndQAreSweptAndCellsAreNot) {
    choose("q");
    ASSERT_TRUE(finished());
    EXPECT_FALSE(choices()[0].log_x) << "a share";
    const auto drag = [&](float from, float to) {
        frame(), frame();
        ui.drag(application.items().find("plot.first.curves")->second, from, to, drawing());
        frame();
    };
    drag(0.5F, 0.9F);
    EXPECT_GT(run().scenario.monitor.values.real("q"), 0.8);
    click("plot.first.menu");
    click("plot.first.menu.eps");
    ASSERT_TRUE(finished());
    EXPECT_TRUE(choices()[0].log_x);
    drag(0.5F, 0.3F);
    EXPECT_LT(run().scenario.pde.values.real("eps"), 1e-5);
    click("plot.first.menu");
    click("plot.first.menu.cells");
    ASSERT_TRUE(finished());
    const Scenario still = run().scenario;
    drag(0.5F, 0.3F);
    EXPECT_EQ(run().scenario, still) << "it drags the axes";
}

TEST_F(ErrorStudyTest, ANumberThatIsAutoIsSetByADrag) {
    choose("K");
    ASSERT_TRUE(finished());
    EXPECT_EQ(application.settings().window.text("first_plot"), "error-study,K,log,log");
    EXPECT_DOUBLE_EQ(now(plot()).x.front(), 0.4) << "what auto stands for";
    frame(), frame();
    ui.drag(application.items().find("plot.first.curves")->second, 0.5F, 0.9F, drawing());
    frame();
    const auto weight = run().scenario.monitor.values.real_or_auto("K");
    ASSERT_TRUE(weight);
    EXPECT_GT(*weight, 1);
    EXPECT_TRUE(study().current());
    EXPECT_EQ(now(plot()).x, std::vector<double>{*weight});
    EXPECT_EQ(solved_scenario().monitor.values.real("K"), *weight);
    application.press_key("Ctrl+Z");
    EXPECT_FALSE(run().scenario.monitor.values.real_or_auto("K")) << "auto again";
}

TEST_F(ErrorStudyTest, ItsNumbersAreCopiedAndSaved) {
    choose();
    ASSERT_TRUE(finished());
    click("plot.first.menu");
    click("plot.first.menu.csv");
    const std::string copied = ImGui::GetClipboardText();
    EXPECT_TRUE(copied.starts_with("pde.eps,domain.cells,energy_error,order,")) << copied.substr(0, 80);
    EXPECT_EQ(std::count(copied.begin(), copied.end(), '\n'), 41);
    click("plot.first.menu");
    click("plot.first.menu.svg");
    const auto file = folder / "layer-1d" / "error-study.svg";
    ASSERT_TRUE(wait_until([&] { return application.messages().last().text == "Saved " + file.string(); }))
        << application.messages().last().text;
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_NE(text.find("Energy error"), std::string::npos);
    EXPECT_EQ(text.find("now"), std::string::npos) << "a file has the results alone";
}

TEST_F(ErrorStudyTest, TheTableOfErrorsFillsWhileItIsOpen) {
    const auto& table = application.error_plots().table();
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().changes.settled(); }));
    EXPECT_FALSE(table.current()) << "nobody looks";
    application.perform("plots"); // it does not need them
    ImGui::GetIO().DisplaySize = {1400, 2000};
    frame(), frame();
    click("errors");
    EXPECT_FALSE(there("errors.7.4"));
    ASSERT_TRUE(wait_until([&] { return there("errors.7.4"); })) << "1024 cells, eps = 1e-8";
    ASSERT_TRUE(wait_until([&] { return table.current() && table.result().done; }));
    EXPECT_EQ(table.result().points.size(), 40U);
    click("errors");
    frame();
    EXPECT_FALSE(there("errors.7.4"));
}

TEST_F(ErrorStudyTest, ItEndsWithItsProblemOrItsPlot) {
    choose();
    ASSERT_TRUE(wait_until([&] { return study().plan() != nullptr; }));
    click("plot.first.quantity");
    click("plot.first.quantity=residual");
    frame();
    EXPECT_FALSE(study().current()) << "nobody looks";
    choose("eps");
    ASSERT_TRUE(wait_until([&] { return study().current(); }));
    Scenario ring = find_scenario(*catalogue, "plane-ring");
    set_value(*catalogue, ring, "domain.cells", std::int64_t{12});
    application.document().replace(run().id, ring);
    ASSERT_TRUE(wait_until([&] { return run().scenario.domain.type != "interval"; }));
    frame();
    EXPECT_FALSE(study().current());
    EXPECT_TRUE(plot().curves.empty());
    click("plot.first.quantity");
    EXPECT_FALSE(there("plot.first.quantity=error-study"));
    EXPECT_TRUE(there("plot.first.quantity=residual"));
}

} // namespace
} // namespace gaspard
