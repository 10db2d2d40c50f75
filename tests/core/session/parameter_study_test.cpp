// Studies of parameters: their axes, their runs, and their tables and plots.
#include "core/base/error.hpp"
#include "core/io/study_files.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/layer_study.hpp"
#include "core/session/run.hpp"
#include "support/messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gaspard {
namespace {

using Texts = std::vector<std::string>;

class ParameterStudy : public testing::Test {
  protected:
    Scenario layer(const Texts& settings = {}) const {
        Scenario scenario = find_scenario(*catalogue, "layer-1d");
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }
    /// The mesh PDE as (H) iterates it.
    Scenario published() const {
        return layer({"method.finish=fixed-point", "method.tolerance=0.4", "method.normalised=false"});
    }
    StudyPlan plan(const Scenario& scenario, const std::string& over, const std::string& lines = {},
                   const std::string& measure = "energy_error") const {
        StudyPlan made{.scenario = scenario, .over = numbers(over, scenario), .measure = measure};
        if (!lines.empty()) made.lines = parse_study_axis(*catalogue, scenario, lines, "--lines");
        return made;
    }
    StudyAxis numbers(const std::string& text, const Scenario& scenario) const {
        return parse_study_numbers(*catalogue, scenario, text, "--over");
    }
    Texts values(const std::string& text) const {
        return parse_study_axis(*catalogue, layer(), text, "--lines").values;
    }
    std::string refusal(const std::string& text) const {
        return message_of<InputError>([&] { numbers(text, layer()); });
    }
    std::string refusal(const StudyPlan& wrong) const {
        return message_of<InputError>([&] { check_study(catalogue, wrong); });
    }
    std::vector<StudyPoint> solved(const StudyPlan& plan, std::stop_token stop = {}) const {
        std::vector<StudyPoint> points;
        run_study(
            catalogue, plan, 1, [&](StudyPoint point) { points.push_back(std::move(point)); }, stop);
        return points;
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(ParameterStudy, AxesAreListsAndRanges) {
    EXPECT_EQ(values("domain.cells=32,8,16"), (Texts{"32", "8", "16"})) << "lines keep their order";
    EXPECT_EQ(numbers("domain.cells=32,8,16", layer()).values, (Texts{"8", "16", "32"}));
    EXPECT_EQ(values("domain.cells=8:100"), (Texts{"8", "16", "32", "64"})) << "times two";
    EXPECT_EQ(values("domain.cells=8:1000:3"), (Texts{"8", "89", "1000"})) << "by a constant factor";
    EXPECT_EQ(values("pde.eps=1:1e-3"), (Texts{"1", "0.1", "0.01", "0.001"})) << "by powers of ten";
    EXPECT_EQ(values("pde.eps=1,1e-4:1e-6:2"), (Texts{"1", "1e-04", "1e-06"}));
    EXPECT_EQ(values("monitor.q=0.1:0.9:5"), (Texts{"0.1", "0.3", "0.5", "0.7", "0.9"})) << "linear";
    EXPECT_EQ(values("monitor.sigma=1:16:3"), (Texts{"1", "4", "16"})) << "on the scale of the row";
    EXPECT_EQ(values("monitor.sigma=0.1:20:3"), (Texts{"0.1", "1.414", "20"})) << "four digits between";
    EXPECT_EQ(values("method.type=bakhvalov,shishkin"), (Texts{"bakhvalov", "shishkin"}));
    EXPECT_EQ(values("monitor.K=auto,1"), (Texts{"auto", "1"}));
}

TEST_F(ParameterStudy, WhatIsNotAllowedIsRefusedBeforeAnythingRuns) {
    for (const auto& [text, part] : {std::pair{"domain.cells", "KEY=VALUES"},
                                     {"domain.cells=", "KEY=VALUES"},
                                     {"domain.cels=8", "domain.cells"},
                                     {"domain.cells=8,0", "1 to 65536"},
                                     {"domain.cells=8:100000", "1 to 65536"},
                                     {"domain.cells=8,8", "names 8 twice"},
                                     {"domain.cells=8:16:1", "from 2 to 1000"},
                                     {"domain.cells=8:16:2:2", "FIRST:LAST"},
                                     {"domain.cells=8:many", "8:1024"},
                                     {"domain.cells=8:8", "single value"},
                                     {"monitor.q=0.1:0.9", "needs a number of values"},
                                     {"pde.eps=1:0", "10⁻¹² to 1"},
                                     {"pde.source=x", "is a text"},
                                     {"view.blend=0,1", "does not change what is solved"},
                                     {"monitor.K=auto,1", "must be numbers"},
                                     {"method.type=shishkin", "must be numbers"}})
        EXPECT_NE(refusal(text).find(part), std::string::npos) << text << ": " << refusal(text);
    const std::string unknown = refusal(plan(layer(), "domain.cells=8", {}, "energy_eror"));
    EXPECT_NE(unknown.find("did you mean 'energy_error'"), std::string::npos) << unknown;
    const std::string twice = refusal(plan(layer(), "domain.cells=8", "domain.cells=8,16"));
    EXPECT_NE(twice.find("domain.cells twice"), std::string::npos) << twice;
    const std::string other = refusal(plan(layer(), "domain.cells=8", "method.type=mesh-pde,newton"));
    EXPECT_NE(other.find("newton"), std::string::npos) << other;
    const std::string many = refusal(plan(layer(), "domain.cells=8:1024:200", "monitor.q=0.1:0.9:99"));
    EXPECT_NE(many.find("at most 5000"), std::string::npos) << many;
}

TEST_F(ParameterStudy, HasTheErrorsOfThePaperAndTheirOrder) {
    const StudyPlan errors = plan(published(), "domain.cells=32:128", "pde.eps=1,1e-4,1e-8");
    check_study(catalogue, errors);
    const auto points = solved(errors);
    ASSERT_EQ(points.size(), 9U);
    const double table[3][3] = {{4.895e-3, 2.448e-3, 1.224e-3}, // docs/layers.md
                                {4.118e-4, 2.054e-4, 1.031e-4},
                                {4.145e-6, 2.072e-6, 1.036e-6}};
    for (std::size_t line = 0; line < 3; ++line)
        for (std::size_t place = 0; place < 3; ++place) {
            const StudyPoint* point = find_point(points, line, place);
            ASSERT_TRUE(point);
            EXPECT_EQ(study_note(*point), "");
            EXPECT_NEAR(study_value(*point, "energy_error"), table[line][place], 1e-3 * table[line][place]);
            const double eps[] = {1, 1e-4, 1e-8};
            EXPECT_DOUBLE_EQ(*point->bound, std::sqrt(eps[line]) / (32 << place));
            if (place == 0) continue;
            EXPECT_NEAR(study_order(errors, *find_point(points, line, place - 1), *point), 1, 0.01);
        }
    // The error is sqrt(eps)/N: of two lines the ratio of errors is that of the bounds.
    EXPECT_NEAR(study_value(points[1], "energy_error") / study_value(points[2], "energy_error"), 100, 1);
}

TEST_F(ParameterStudy, SaysOnceWhyErrorsAreNotMeasured) {
    const auto absences = [&](const std::string& name, const Texts& settings, const std::string& over,
                              const std::string& measure = "energy_error") {
        Scenario scenario = find_scenario(*catalogue, name);
        apply_settings(*catalogue, scenario, settings);
        const auto points = solved(plan(scenario, over, {}, measure));
        for (const StudyPoint& point : points)
            EXPECT_EQ(std::isnan(study_value(point, measure)), !study_note(point).empty());
        const Plot plot = study_plot(plan(scenario, over, {}, measure), points);
        const bool none = std::all_of(points.begin(), points.end(),
                                      [](const StudyPoint& point) { return !point.absence.empty(); });
        EXPECT_EQ(plot.y.label.ends_with(", not measured"), none);
        EXPECT_EQ(plot.curves.size(), none ? 1U : 3U) << "no bound of nothing";
        return study_absences(points);
    };
    const Texts coarse{"pde.eps=0.1", "method.final_solves=1"};
    EXPECT_EQ(absences("layer-2d", coarse, "domain.cells=8,66,68"),
              Texts{"errors beyond 64 cells per side are measured only with method.reference=on"});
    EXPECT_EQ(absences("layer-2d", {"method.reference=off"}, "domain.cells=8"),
              Texts{"method.reference=off measures no errors; auto and on do"});
    EXPECT_EQ(absences("layer-2d", {"pde.type=none", "monitor.eps=1e-3"}, "domain.cells=8"),
              Texts{"without a problem to solve there are no errors; set pde.type"});
    EXPECT_EQ(absences("layer-2d", coarse, "domain.cells=8", "exact_energy_error"),
              Texts{"no closed form of the solution is known"});
    EXPECT_EQ(absences("layer-1d", {}, "domain.cells=8"), Texts{});
}

TEST_F(ParameterStudy, ErrorsOverEpsHaveItsExponent) {
    const StudyPlan over = plan(layer(), "pde.eps=1e-8,1e-6,1e-4");
    const auto points = solved(over);
    ASSERT_EQ(points.size(), 3U);
    EXPECT_EQ(points[0].x, 1e-8) << "in order";
    EXPECT_TRUE(has_orders(over));
    EXPECT_NEAR(study_order(over, points[0], points[1]), 0.5, 0.01);
    EXPECT_FALSE(has_orders(plan(layer(), "monitor.q=0.1,0.5")));
}

TEST_F(ParameterStudy, BadValuesOfSigmaAndQCostAccuracy) {
    // Beside its layer the solution is curved, so that cells are needed there, too.
    const auto over = [&](const std::string& text) {
        std::vector<double> errors;
        for (const StudyPoint& point : solved(plan(layer({"pde.source=cos(pi*x/2)"}), text)))
            errors.push_back(study_value(point, "energy_error"));
        return errors;
    };
    const auto q = over("monitor.q=0.01,0.5,0.99");
    ASSERT_EQ(q.size(), 3U);
    EXPECT_NEAR(q[1], 4.871e-4, 1e-6);
    EXPECT_GT(q[0], 50 * q[1]) << "hardly a cell in the layer";
    EXPECT_GT(q[2], 50 * q[1]) << "hardly a cell beside it";
    const auto sigma = over("monitor.sigma=0.2,2.5,20");
    ASSERT_EQ(sigma.size(), 3U);
    EXPECT_EQ(sigma[1], q[1]);
    EXPECT_GT(sigma[0], 2 * sigma[1]) << "the layer is left too early";
    EXPECT_GT(sigma[2], 5 * sigma[1]) << "cells of the layer are spread too far";
}

TEST_F(ParameterStudy, RunsAreThoseOfTheScenarioWithTheseValues) {
    const auto points = solved(plan(layer(), "domain.cells=16", "method.type=bakhvalov,equidistribute"));
    ASSERT_EQ(points.size(), 2U);
    for (std::size_t line = 0; line < 2; ++line) {
        gaspard::Run run(catalogue, layer({line == 0 ? "method.type=bakhvalov" : "method.type=equidistribute",
                                           "domain.cells=16"}));
        run.solve();
        EXPECT_EQ(study_value(points[line], "energy_error"), run.history().back().value("energy_error"));
        EXPECT_EQ(study_value(points[line], "iterations"), run.history().back().iteration);
    }
    EXPECT_NE(study_value(points[0], "energy_error"), study_value(points[1], "energy_error"));
}

TEST_F(ParameterStudy, VariesTheNumbersOfTime) {
    Scenario moving = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, moving,
                   {"domain.cells=12", "monitor.amplitude=2", "method.type=newton", "time.end=0.4",
                    "time.step=0.1", "time.monitor.center_x=center_x + t/4",
                    "time.monitor.radius=0.25 - t/9"});
    const auto points = solved(plan(moving, "time.step=0.1,0.05", {}, "equidistribution"));
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].x, 0.05) << "in order";
    EXPECT_GT(study_value(points[0], "iterations"), study_value(points[1], "iterations") + 3);
    for (const StudyPoint& point : points) EXPECT_EQ(point.report->value("time"), 0.4);
    const auto refused = [&](const std::string& over, const Texts& settings = {},
                             const std::string& lines = {}) {
        Scenario scenario = moving;
        apply_settings(*catalogue, scenario, settings);
        try {
            check_study(catalogue, plan(scenario, over, lines, "equidistribution"));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    for (const char* over : {"time.end=0.1,0.2", "time.start=0,0.2", "time.factor=1.1,1.2",
                             "monitor.center_x=0.4,0.5", "monitor.center_y=0.4,0.5", "monitor.amplitude=1,2"})
        EXPECT_EQ(refused(over), "") << over;
    EXPECT_EQ(refused("time.tau=0.1,0.2"), "time.tau has no effect unless time.rule is relaxation");
    EXPECT_EQ(refused("time.tau=0.1,0.2", {"time.rule=relaxation"}), "");
    EXPECT_EQ(refused("time.tau=0.1,0.2", {}, "time.rule=tolerance,relaxation"), "") << "in some of the runs";
    EXPECT_EQ(refused("time.step=0.1,0.2", {"time.end=0"}),
              "time.step has no effect: no time passes unless time.end is after time.start");
    EXPECT_EQ(refused("time.end=1,2", {"time.end=0"}), "");
    EXPECT_EQ(refused("monitor.radius=0.2,0.3"),
              "monitor.radius has no effect while time passes: time.monitor.radius does not use 'radius'");
    EXPECT_EQ(
        refused("monitor.center_y=0.4,0.5", {"time.monitor.center_x=", "time.path=0 0.4 0.5; 1 0.6 0.5"}),
        "monitor.center_y has no effect while time passes: time.path sets it");
    EXPECT_NE(message_of<InputError>([&] { numbers("time.speed=1,2", moving); }).find("does not change"),
              std::string::npos);
}

TEST_F(ParameterStudy, RunsAreMeasuredInFull) {
    const auto points = solved(plan(layer({"method.diagnostics=none"}), "domain.cells=32"));
    EXPECT_NEAR(study_value(points.at(0), "energy_error"), 4.171e-4, 1e-7);
    const auto interpolated = solved(plan(layer(), "domain.cells=32", {}, "l2_error"));
    EXPECT_GT(study_value(interpolated.at(0), "l2_error"), 0) << "on request, since it takes time";
}

TEST_F(ParameterStudy, WhatFailsIsAMarkAndTheOthersGoOn) {
    // Both ends have a layer: the mesh needs an even number of cells.
    const Scenario both = layer({"method.type=shishkin", "method.layers=both"});
    const StudyPlan some = plan(both, "domain.cells=15,16,17");
    check_study(catalogue, some);
    const auto points = solved(some);
    ASSERT_EQ(points.size(), 3U);
    EXPECT_TRUE(points[0].refused && points[2].refused);
    EXPECT_NE(points[0].complaint.find("even"), std::string::npos) << points[0].complaint;
    EXPECT_TRUE(std::isnan(study_value(points[0], "energy_error")));
    EXPECT_GT(study_value(points[1], "energy_error"), 0);
    const Plot plot = study_plot(some, points);
    ASSERT_EQ(plot.marks.size(), 2U);
    EXPECT_EQ(plot.marks[1].x, 17);
    EXPECT_EQ(plot.marks[1].label, points[2].complaint);
    const std::string none = refusal(plan(both, "domain.cells=15,17"));
    EXPECT_NE(none.find("even"), std::string::npos) << none;
    const auto limited = solved(plan(layer({"method.max_iterations=2"}), "domain.cells=64"));
    EXPECT_EQ(study_note(limited.at(0)), "iteration-limit after 2 iterations");
}

TEST_F(ParameterStudy, EndsWhenAskedTo) {
    std::stop_source stop;
    std::size_t done = 0;
    const auto count = [&](const StudyPoint&) {
        if (++done == 2) stop.request_stop();
    };
    run_study(catalogue, plan(layer(), "domain.cells=8:1024"), 1, count, stop.get_token());
    EXPECT_EQ(done, 2U);
}

TEST_F(ParameterStudy, HasATableARecordAndAPlot) {
    const StudyPlan errors = plan(layer(), "domain.cells=16,32", "pde.eps=1,1e-4");
    const auto points = solved(errors);
    const std::string csv = study_csv(errors, points);
    EXPECT_TRUE(
        csv.starts_with("pde.eps,domain.cells,energy_error,order,bound,iterations,status,note\n1,16,"));
    EXPECT_NE(csv.find("\n1e-04,32,"), std::string::npos) << csv;
    const auto json = nlohmann::json::parse(study_json(errors, points));
    EXPECT_EQ(json["scenario"], "layer-1d");
    EXPECT_EQ(json["lines"]["values"], (Texts{"1", "1e-04"}));
    EXPECT_TRUE(json["runs"][0]["order"].is_null());
    EXPECT_NEAR(json["runs"][3]["order"].get<double>(), 1, 0.02);
    const Plot plot = study_plot(errors, points);
    ASSERT_EQ(plot.curves.size(), 5U) << "two lines, their bounds and an entry of the legend";
    EXPECT_EQ(plot.curves[1].label, "ε = 10⁻⁴");
    EXPECT_EQ(plot.curves[3].label, "") << "no entry of its own";
    EXPECT_EQ(plot.curves[3].name, "ε = 10⁻⁴: √ε / N");
    EXPECT_EQ(study_plot(errors, {}).y.label, plot.y.label) << "before the first run";
    EXPECT_EQ(measure_label({}, "cpu_seconds"), "CPU time in seconds");
    EXPECT_EQ(plot.curves[1].x, (std::vector<double>{16, 32}));
    EXPECT_TRUE(plot.curves[1].markers);
    EXPECT_EQ(plot.curves[3].colour, plot.curves[1].colour);
    EXPECT_DOUBLE_EQ(plot.curves[3].y[0], 1e-2 / 16);
    EXPECT_TRUE(plot.curves[3].behind);
    EXPECT_EQ(plot.curves[4].label, "√ε / N");
    EXPECT_TRUE(plot.x.logarithmic && plot.y.logarithmic);
    EXPECT_EQ(plot.x.label, "N");
    EXPECT_EQ(plot.y.label, "Energy error, P2 reference");
    EXPECT_EQ(plot.title, "Boundary layer in one dimension");
}

TEST_F(ParameterStudy, TheUsualOnesDependOnWhatDoesNotVary) {
    EXPECT_TRUE(study_variables(find_scenario(*catalogue, "plane-ring")).empty());
    EXPECT_TRUE(study_variables(layer({"pde.type=none"})).empty());
    EXPECT_EQ(study_variables(layer()), (Texts{"cells", "eps", "q", "sigma", "monitor.eps", "beta", "K"}));
    EXPECT_EQ(study_key(layer({"method.type=bakhvalov"}), "sigma"), "method.sigma");
    EXPECT_EQ(study_variables(layer({"method.type=bakhvalov"})),
              (Texts{"cells", "eps", "q", "sigma", "method.eps", "beta"}));
    EXPECT_EQ(study_variables(layer({"method.type=solution-adapted"})), (Texts{"cells", "eps", "smoothing"}))
        << "the monitor has no effect";
    EXPECT_EQ(study_variables(layer({"monitor.type=constant"})), (Texts{"cells", "eps", "value"}));
    EXPECT_EQ(study_variables(layer({"monitor.K=1"})),
              (Texts{"cells", "eps", "sigma", "monitor.eps", "beta", "K"}))
        << "q has no effect";
    const auto usual = [&](const Texts& settings, StudyVariable variable) {
        return usual_study(*catalogue, layer(settings), variable);
    };
    const StudyPlan cells = usual({}, "cells");
    EXPECT_EQ(cells.over.values.back(), "1024");
    EXPECT_EQ(cells.lines.values, (Texts{"1", "0.01", "1e-04", "1e-06", "1e-08"}));
    EXPECT_TRUE(same_study(cells, usual({"pde.eps=1e-7", "domain.cells=100"}, "cells")));
    EXPECT_FALSE(same_study(cells, usual({"monitor.sigma=3"}, "cells")));
    EXPECT_TRUE(same_study(usual({}, "sigma"), usual({"monitor.sigma=3"}, "sigma")));
    EXPECT_FALSE(same_study(usual({}, "sigma"), usual({"domain.cells=9"}, "sigma")));
    const auto in_time = [&](const char* setting) {
        return usual({"time.end=1", "time.step=0.1", setting}, "cells");
    };
    EXPECT_TRUE(same_study(in_time("time.speed=0"), in_time("time.speed=2"))) << "only the window has a speed";
    EXPECT_FALSE(same_study(in_time("time.speed=0"), in_time("time.step=0.2")));
    for (const char* name : {"layer-1d-coupled", "layer-1d-convection", "layer-2d", "layer-quadrilateral",
                             "layer-2d-convection"}) {
        const Scenario scenario = find_scenario(*catalogue, name);
        for (const StudyVariable& variable : study_variables(scenario))
            EXPECT_NO_THROW(check_study(catalogue, usual_study(*catalogue, scenario, variable))) << name;
    }
}

TEST_F(ParameterStudy, EveryNumberOfTheMonitorHasUsualValuesAndIsNamed) {
    const auto values = [&](const Scenario& scenario, const std::string& key) {
        return usual_axis(*catalogue, scenario, key).values;
    };
    const Texts weights = values(layer(), "monitor.K");
    EXPECT_EQ(weights.size(), 21U) << "four per power of ten";
    EXPECT_EQ(weights.front(), "0.001");
    EXPECT_EQ(weights.back(), "100");
    EXPECT_EQ(values(layer(), "monitor.eps").size(), 25U);
    EXPECT_EQ(values(find_scenario(*catalogue, "layer-2d"), "monitor.eps").size(), 6U);
    EXPECT_EQ(values(layer({"method.type=solution-adapted"}), "method.smoothing").size(), 21U)
        << "all of them";
    EXPECT_EQ(study_label(layer(), "eps"), "ε");
    EXPECT_EQ(study_label(layer(), "monitor.eps"), "Layer width") << "the symbol is that of the problem";
    EXPECT_EQ(study_label(layer(), "beta"), "β");
    EXPECT_EQ(study_label(layer(), "no-such"), "no-such");
    const std::string unknown =
        message_of<InputError>([&] { values(layer({"method.type=bakhvalov"}), "method.layers"); });
    EXPECT_NE(unknown.find("method.layers=VALUES"), std::string::npos) << unknown;
    const StudyPlan widths = usual_study(*catalogue, layer(), "monitor.eps");
    EXPECT_EQ(study_plot(widths, {}).x.label, "Layer width ε") << "lines have an ε, too";
    EXPECT_EQ(study_plot(usual_study(*catalogue, layer(), "beta"), {}).x.label, "β");
}

TEST_F(ParameterStudy, AFormulasParametersAreNumbersOfTheMonitor) {
    const Scenario scenario =
        layer({"monitor.type=formula", "monitor.expression=max(1, K/eps*exp(-x/(cells*eps)))",
               "monitor.eps=1e-4", "monitor.cells=2.5", "monitor.K=1"});
    const auto variables = study_variables(scenario);
    for (const char* one : {"monitor.eps", "monitor.cells", "K"})
        EXPECT_NE(std::find(variables.begin(), variables.end(), one), variables.end()) << one;
    EXPECT_EQ(study_number(scenario, "monitor.cells"), 2.5);
    EXPECT_EQ(study_key(scenario, "cells"), "domain.cells");
    for (const std::string& one : variables)
        EXPECT_NO_THROW(check_study(catalogue, usual_study(*catalogue, scenario, one))) << one;
}

TEST_F(ParameterStudy, TheTrueWidthOfALayerIsTheBestAndAutoStandsForIt) {
    EXPECT_EQ(study_number(layer(), "monitor.eps"), 1e-4);
    EXPECT_DOUBLE_EQ(study_number(layer(), "monitor.K").value_or(0), 0.4) << "q/(σ(1 - q))";
    EXPECT_EQ(study_number(layer({"monitor.K=3"}), "monitor.K"), 3);
    EXPECT_FALSE(study_number(layer(), "monitor.left"));
    const Scenario curved = layer({"pde.source=cos(pi*x/2)"});
    const auto points = solved(plan(curved, "monitor.eps=1e-8,1e-6,1e-4,1e-2,1"));
    ASSERT_EQ(points.size(), 5U);
    std::vector<double> errors;
    for (const StudyPoint& point : points) errors.push_back(study_value(point, "energy_error"));
    EXPECT_EQ(std::min_element(errors.begin(), errors.end()) - errors.begin(), 2) << "1e-4";
    EXPECT_GT(errors[1], 5 * errors[2]);
    EXPECT_GT(errors[3], 5 * errors[2]);
}

TEST_F(ParameterStudy, ThePresentEpsIsALineOfItsOwn) {
    const auto lines = [&](const Texts& settings, const char* variable) {
        return usual_study(*catalogue, layer(settings), variable).lines.values;
    };
    EXPECT_EQ(lines({"pde.eps=1e-5"}, "sigma"), (Texts{"1", "0.01", "1e-04", "1e-05", "1e-06", "1e-08"}));
    EXPECT_EQ(lines({"pde.eps=1e-5"}, "cells").size(), 5U) << "where a change of eps is not to begin it anew";
    EXPECT_EQ(lines({"pde.eps=1e-12"}, "sigma").size(), 5U) << "not beyond the others";
    EXPECT_EQ(lines({"domain.cells=32"}, "eps"), (Texts{"16", "32", "64", "256", "1024"}));
    EXPECT_EQ(lines({"domain.cells=64"}, "eps").size(), 4U);
}

} // namespace
} // namespace gaspard
