#include "gui/panels/plot_choice.hpp"
#include "gui/run_fixtures.hpp"

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
    ChangeMark& mark = runs[1].marks.emplace_back();
    mark.iteration = 5;
    mark.seconds = mark.last_seconds = 0.05;
    mark.text = "amplitude 10 to 20";
    return runs;
}

TEST(PlotChoice, ReadsBackFromItsText) {
    std::set<std::string> texts;
    for (const Quantity quantity : quantities())
        for (const Abscissa abscissa : abscissas())
            for (const bool log_x : {false, true})
                for (const bool log_y : {false, true}) {
                    const PlotChoice choice{quantity, abscissa, log_x, log_y};
                    EXPECT_TRUE(texts.insert(format_choice(choice)).second);
                    const auto read = parse_choice(format_choice(choice));
                    ASSERT_TRUE(read) << format_choice(choice);
                    EXPECT_EQ(*read, choice);
                }
    EXPECT_EQ(texts.size(), 4U * 2 * 2 * 2);
    EXPECT_EQ(format_choice({}), "residual,iterations,linear,log");
    for (const char* wrong :
         {"", "residual", "residual,iterations,linear", "residual,iterations,linear,log,",
          "residue,iterations,linear,log", "residual,iterations,linear,logarithmic", ",,,"})
        EXPECT_FALSE(parse_choice(wrong)) << wrong;
}

TEST(ViewOfRuns, ShowsTheChosenColumnsOfAllThatIsNotHidden) {
    DocumentRuns runs = two_runs();
    PlotView view = view_of_runs(runs, {});
    ASSERT_EQ(view.curves.size(), 2U);
    EXPECT_EQ(view.curves[0].y.data(), runs[0].curves.residual.values.data()) << "looked at, not copied";
    EXPECT_EQ(view.curves[1].colour, 1U);
    EXPECT_EQ(view.curves[1].label, "second");
    ASSERT_EQ(view.marks.size(), 1U);
    EXPECT_EQ(view.marks[0].x, 5);
    view = view_of_runs(runs, {.abscissa = Abscissa::seconds});
    EXPECT_EQ(view.curves[0].x.data(), runs[0].curves.residual.seconds.data());
    EXPECT_EQ(view.marks[0].x, 0.05);
    runs[1].hidden = true;
    view = view_of_runs(runs, {.quantity = Quantity::jacobian, .log_y = false});
    ASSERT_EQ(view.curves.size(), 2U) << "the largest and the smallest of one run";
    EXPECT_EQ(view.curves[0].colour, view.curves[1].colour);
    EXPECT_EQ(view.curves[0].y.back(), 3);
    EXPECT_EQ(view.curves[1].y.back(), 0.98);
    EXPECT_TRUE(view.marks.empty());
    EXPECT_EQ(view_of_runs(runs, {.quantity = Quantity::step_size}).curves[0].y.size(), 20U);
    EXPECT_EQ(view_of_runs(runs, {.quantity = Quantity::equidistribution}).curves[0].y.size(), 11U)
        << "where it was not measured the curve goes on";
}

TEST(PlotOfRuns, HasItsOwnNumbersAndIsThinnedOut) {
    const Plot small = plot_of_runs(two_runs(), {.quantity = Quantity::jacobian}, {});
    EXPECT_EQ(small.title, "Jacobian range");
    EXPECT_EQ(small.x.label, "iteration");
    ASSERT_EQ(small.curves.size(), 4U);
    EXPECT_EQ(small.curves[0].label, "first");
    EXPECT_EQ(small.curves[1].label, "") << "one entry of the legend per run";
    EXPECT_EQ(small.curves[0].x.size(), 11U);
    ASSERT_EQ(small.marks.size(), 1U);
    EXPECT_EQ(small.marks[0].label, "amplitude 10 to 20");

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
