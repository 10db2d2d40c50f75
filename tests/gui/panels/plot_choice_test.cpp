#include "core/scenario/time_rows.hpp"
#include "core/scenario/toml.hpp"
#include "gui/panels/plot_choice.hpp"
#include "gui/run_fixtures.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gaspard {
namespace {

DocumentRuns two_runs(int iterations = 20) {
    DocumentRuns runs;
    runs.push_back(made_up_run("first", iterations));
    runs.push_back(made_up_run("second", 10));
    runs[1].colour = 1;
    runs[1].earlier.push_back({made_up_run("older", 30).curves, "amplitude 5"});
    runs[1].earlier.push_back({made_up_run("old", 7).curves, "amplitude 10"});
    return runs;
}

TEST(PlotChoice, ReadsBackFromItsText) {
    std::set<std::string> texts;
    for (const char* plot : {"residual", "equidistribution", "jacobian", "step-size", "error-study"}) {
        const bool study = std::string_view(plot) == error_study_plot;
        for (const Abscissa& abscissa : study ? std::vector<Abscissa>{"cells", "monitor.eps", "K"}
                                              : std::vector<Abscissa>{"iterations", "seconds"})
            for (const bool log_x : {false, true})
                for (const bool log_y : {false, true}) {
                    const PlotChoice choice{plot, abscissa, log_x, log_y};
                    EXPECT_TRUE(texts.insert(format_choice(choice)).second);
                    const auto read = parse_choice(format_choice(choice));
                    ASSERT_TRUE(read) << format_choice(choice);
                    EXPECT_EQ(*read, choice);
                }
    }
    EXPECT_EQ(texts.size(), 4U * 2 * 2 * 2 + 3 * 2 * 2);
    EXPECT_EQ(format_choice({}), "residual,iterations,linear,log");
    for (const char* wrong : {"", "residual", "residual,iterations,linear", "residual,iterations,linear,log,",
                              "resi due,iterations,linear,log", "residual,iterations,linear,logarithmic",
                              "residual,cells,log,log", "error-study,iterations,linear,log",
                              "error-study,a b,log,log", "error-study,,log,log", ",,,"})
        EXPECT_FALSE(parse_choice(wrong)) << wrong;
}

TEST(PlotsOfRuns, AreThoseOfTheSeriesThatTheRunsReport) {
    DocumentRuns runs = two_runs();
    const auto names = [&] {
        std::vector<std::string> found;
        for (const RunPlot& plot : plots_of(runs)) found.emplace_back(plot.name);
        return found;
    };
    EXPECT_EQ(names(), (std::vector<std::string>{"residual", "equidistribution", "jacobian", "step-size"}));
    EXPECT_EQ(plot_label(runs, "jacobian"), "Jacobian range");
    EXPECT_EQ(plot_label(runs, "drag-force"), "drag-force") << "of no run";
    // A run goes on with a method that reports more.
    const auto table = std::make_shared<const SeriesTable>(
        SeriesInfo{.name = "residual", .label = "Increment"}, std::vector<SeriesInfo>{},
        std::vector<SeriesInfo>{{.name = "drag_force", .label = "Drag"}});
    StepReport report{.iteration = 11, .residual = 1, .step_size = 1, .series = table};
    report.set("drag_force", 2.5);
    runs[1].curves.append(report);
    EXPECT_EQ(names().back(), "drag-force");
    EXPECT_EQ(names().size(), 5U);
    EXPECT_EQ(plot_label(runs, "drag-force"), "Drag");
    EXPECT_EQ(plot_label(runs, "residual"), "Residual") << "of the first run";
    const PlotView view = view_of_runs(runs, {.plot = "drag-force"});
    ASSERT_EQ(view.curves.size(), 1U) << "the first run has none";
    EXPECT_EQ(view.curves[0].label, "second");
    EXPECT_EQ(view.y.label, "Drag") << "it has no symbol";
    ASSERT_EQ(view.curves[0].y.size(), 1U);
    EXPECT_EQ(view.curves[0].y[0], 2.5);
    EXPECT_EQ(view_of_runs(runs, {.plot = "residual"}).curves[1].y.size(), 12U) << "the curve goes on";
}

TEST(ViewOfRuns, ShowsTheChosenColumnsOfAllThatIsNotHidden) {
    DocumentRuns runs = two_runs();
    PlotView view = view_of_runs(runs, {});
    ASSERT_EQ(view.curves.size(), 4U);
    EXPECT_EQ(view.curves[0].y.data(), runs[0].curves.find("residual")->trace.values.data())
        << "looked at, not copied";
    EXPECT_EQ(view.curves[1].colour, 1U);
    EXPECT_EQ(view.curves[1].label, "second");
    EXPECT_EQ(view.curves[2].name, "amplitude 10") << "the newest of the earlier solves first";
    EXPECT_EQ(view.curves[2].label, "") << "it has no entry in the legend";
    EXPECT_EQ(view.curves[2].colour, 1U);
    EXPECT_LT(view.curves[2].opacity, 1);
    EXPECT_LT(view.curves[3].opacity, view.curves[2].opacity) << "the older the fainter";
    EXPECT_EQ(view.curves[3].x.front(), 0) << "with iterations of its own";
    EXPECT_LT(home_range(view, false).high, 25) << "the axes span what is not faded";
    EXPECT_EQ(view_of_runs(runs, {}, false).curves.size(), 2U) << "folded away";
    view = view_of_runs(runs, {.abscissa = "seconds"});
    EXPECT_EQ(view.curves[0].x.data(), runs[0].curves.find("residual")->trace.seconds.data());
    runs[1].hidden = true;
    view = view_of_runs(runs, {.plot = "jacobian", .log_y = false});
    ASSERT_EQ(view.curves.size(), 2U) << "the largest and the smallest of one run";
    EXPECT_EQ(view.curves[0].colour, view.curves[1].colour);
    EXPECT_EQ(view.curves[0].y.back(), 3);
    EXPECT_EQ(view.curves[1].y.back(), 0.98);
    EXPECT_EQ(view_of_runs(runs, {.plot = "step-size"}).curves[0].y.size(), 20U);
    EXPECT_EQ(view_of_runs(runs, {.plot = "equidistribution"}).curves[0].y.size(), 11U)
        << "where it was not measured the curve goes on";
}

TEST(ViewOfRuns, ShowsTheToleranceInThePlotOfTheCriterion) {
    DocumentRuns runs = two_runs();
    for (DocumentRun& run : runs) {
        run.history = {StepReport{}};
        run.scenario.method.values =
            Values("method", {{.key = "tolerance", .minimum = 0, .maximum = 1, .default_value = 1e-8}});
    }
    ASSERT_EQ(view_of_runs(runs, {}).levels.size(), 1U) << "one line where both have the same";
    EXPECT_EQ(view_of_runs(runs, {}).levels[0].label, "tolerance 10⁻⁸");
    EXPECT_LT(home_range(view_of_runs(runs, {}), true).low, -8);
    EXPECT_TRUE(view_of_runs(runs, {.plot = "equidistribution"}).levels.empty());
    EXPECT_EQ(plot_of_runs(runs, {}).levels.size(), 1U);
    runs[1].scenario.method.values.set("tolerance", 1e-4);
    EXPECT_EQ(view_of_runs(runs, {}).levels.size(), 2U);
    runs[1].hidden = true;
    EXPECT_EQ(view_of_runs(runs, {}).levels.size(), 1U);
    EXPECT_EQ(view_of_runs(runs, {}).y.label, "‖r‖ / ‖θ‖");
}

TEST(ViewOfRuns, ShowsNoToleranceThatTimeStepsAreNotSolvedTo) {
    DocumentRuns runs;
    const auto catalogue = builtin_catalogue();
    DocumentRun& run = runs.push_back({});
    run.scenario = find_scenario(catalogue, "plane-ring");
    ASSERT_EQ(run.scenario.time.text("rule"), time_rule::equidistribution);
    run.history = made_up_time_steps(0);
    EXPECT_EQ(view_of_runs(runs, {}).levels.size(), 1U) << "the solve for the start";
    run.history = made_up_time_steps(4);
    EXPECT_TRUE(view_of_runs(runs, {}).levels.empty());
    run.scenario.time.set("rule", std::string(time_rule::tolerance));
    EXPECT_EQ(view_of_runs(runs, {}).levels.size(), 1U);
    run.scenario.time.set("tolerance", 1e-3);
    ASSERT_EQ(view_of_runs(runs, {}).levels.size(), 1U);
    EXPECT_EQ(view_of_runs(runs, {}).levels[0].y, 1e-3);
}

TEST(PlotOfRuns, HasItsOwnNumbersAndIsThinnedOut) {
    const Plot small = plot_of_runs(two_runs(), {.plot = "jacobian"}, {});
    EXPECT_EQ(small.title, "Jacobian range");
    EXPECT_EQ(small.x.label, "iteration");
    ASSERT_EQ(small.curves.size(), 4U);
    EXPECT_EQ(small.curves[0].label, "first");
    EXPECT_EQ(small.curves[1].label, "") << "one entry of the legend per run";
    EXPECT_EQ(small.curves[0].x.size(), 11U);

    DocumentRuns runs = two_runs(3);
    for (int i = 4; i < 50000; ++i) {
        const StepReport report{.iteration = i, .residual = i == 30001 ? 1e6 : 1e-3 * (2 + i % 2)};
        runs[0].curves.append(report);
    }
    const Plot large = plot_of_runs(runs, {}, {});
    EXPECT_LT(large.curves[0].x.size(), 10000U);
    EXPECT_NEAR(*std::max_element(large.curves[0].y.begin(), large.curves[0].y.end()), 1e6, 1e-3)
        << "no peak is lost";
    EXPECT_NEAR(large.curves[0].x.back(), 49999, 1e-6);
}

TEST(PlotOfRuns, SaysWhatIsToBeSeen) {
    const Plot plot = plot_of_runs(two_runs(), {}, {.x = AxisRange{2, 8}, .y = AxisRange{-3, -1}});
    EXPECT_EQ(plot.x.low, 2);
    EXPECT_EQ(plot.x.high, 8);
    EXPECT_NEAR(*plot.y.low, 1e-3, 1e-12);
    EXPECT_NEAR(*plot.y.high, 1e-1, 1e-12);
    EXPECT_FALSE(plot_of_runs(two_runs(), {}).x.low.has_value());
}

} // namespace
} // namespace gaspard
