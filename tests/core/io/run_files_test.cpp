// The files of a whole run, read back as a script would: JSON by a parser, CSV by splitting at commas.
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/diagnostics/exact_map.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/io/history_file.hpp"
#include "core/io/run_files.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/state_file.hpp"
#include "core/scenario/toml.hpp"
#include "support/comma_locale.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

namespace gaspard {
namespace {

using OrderedJson = nlohmann::ordered_json;

Scenario small_scenario(const Catalogue& catalogue, int iterations = 6) {
    Scenario scenario = find_scenario(catalogue, "plane-ring");
    apply_settings(catalogue, scenario,
                   {"domain.cells=8", "monitor.center_x=0.25",
                    "method.max_iterations=" + std::to_string(iterations), "method.diagnostics_every=4"});
    return scenario;
}

Run finished_run(RunOptions options = {}, int iterations = 6) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    gaspard::Run run(catalogue, small_scenario(*catalogue, iterations), std::move(options));
    while (run.status() == RunStatus::running) run.step();
    return run;
}

std::vector<std::string> keys_of(const OrderedJson& json) {
    std::vector<std::string> keys;
    for (const auto& item : json.items()) keys.push_back(item.key());
    return keys;
}

std::vector<std::vector<std::string>> split_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, {""});
    for (const char c : text) {
        if (c == '\n')
            rows.push_back({""});
        else if (c == ',')
            rows.back().emplace_back();
        else
            rows.back().back() += c;
    }
    EXPECT_EQ(rows.back(), std::vector<std::string>{""}) << "the file ends with a line's end";
    rows.pop_back();
    return rows;
}

double number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    EXPECT_TRUE(!text.empty() && *end == '\0') << "'" << text << "' is a number";
    return value;
}

TEST(Summary, HasTheFieldsOfTheContractInTheirOrder) {
    gaspard::Run run = finished_run();
    const OrderedJson json = OrderedJson::parse(summary_json(run));
    EXPECT_EQ(keys_of(json), (std::vector<std::string>{"scenario",
                                                       "modified",
                                                       "domain",
                                                       "monitor",
                                                       "method",
                                                       "cells",
                                                       "unknowns",
                                                       "status",
                                                       "iterations",
                                                       "residual",
                                                       "equidistribution",
                                                       "theta",
                                                       "tangled_cells",
                                                       "min_jacobian",
                                                       "max_jacobian",
                                                       "exact_rms",
                                                       "exact_rms_nodes",
                                                       "cell_quality",
                                                       "interpolation",
                                                       "setup_seconds",
                                                       "solve_seconds",
                                                       "cpu_seconds",
                                                       "seconds_per_iteration",
                                                       "peak_memory_bytes",
                                                       "version",
                                                       "inner_iterations",
                                                       "note"}));
}

TEST(Summary, SaysWhatTheRunFound) {
    gaspard::Run run = finished_run();
    const OrderedJson json = OrderedJson::parse(summary_json(run));
    const StepReport& last = run.history().back();
    EXPECT_EQ(json["scenario"], "plane-ring");
    EXPECT_EQ(json["domain"], (OrderedJson{{"type", "plane"}, {"boundary", "periodic"}, {"cells", 8}}));
    EXPECT_EQ(json["monitor"]["type"], "ring");
    EXPECT_EQ(json["monitor"]["center_x"], 0.25);
    EXPECT_EQ(json["method"]["type"], "relaxation");
    EXPECT_EQ(json["method"]["max_iterations"], 6);
    for (const auto* section : {&run.scenario().domain, &run.scenario().monitor, &run.scenario().method})
        EXPECT_EQ(json[section->values.section()].size(), section->values.rows().size() + 1);
    EXPECT_EQ(json["cells"], 64);
    EXPECT_EQ(json["unknowns"], run.discretisation().unknowns());
    EXPECT_EQ(json["status"], "iteration-limit");
    EXPECT_EQ(json["iterations"], 6);
    EXPECT_EQ(json["residual"].get<double>(), last.residual);
    EXPECT_EQ(json["equidistribution"].get<double>(), last.value("equidistribution"));
    EXPECT_EQ(json["theta"].get<double>(), last.value("theta"));
    EXPECT_EQ(json["tangled_cells"], 0);
    EXPECT_EQ(json["min_jacobian"].get<double>(), last.value("min_jacobian"));
    EXPECT_EQ(json["max_jacobian"].get<double>(), last.value("max_jacobian"));
    EXPECT_TRUE(json["exact_rms"].is_null());
    EXPECT_EQ(json["setup_seconds"].get<double>(), run.setup_seconds());
    EXPECT_EQ(json["solve_seconds"].get<double>(), last.seconds);
    EXPECT_EQ(json["cpu_seconds"].get<double>(), last.cpu_seconds);
    EXPECT_DOUBLE_EQ(json["seconds_per_iteration"].get<double>() * 6, last.seconds);
    EXPECT_GT(json["peak_memory_bytes"].get<std::uint64_t>(), 1u << 20); // this very process needs more
    EXPECT_EQ(json["version"], "0.1.0");
}

TEST(Summary, HasTheCellQualityOfTheLastMeshThatTheHistoryHasOnRequest) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = small_scenario(*catalogue, 3);
    scenario.method.values.set("cell_quality", true);
    gaspard::Run run(catalogue, scenario);
    run.solve();
    const OrderedJson quality = OrderedJson::parse(summary_json(run))["cell_quality"];
    const StepReport& last = run.history().back();
    EXPECT_EQ(quality["aspect_ratio"]["worst"].get<double>(), last.value("max_aspect_ratio"));
    EXPECT_EQ(quality["skewness"]["mean"].get<double>(), last.value("mean_skewness"));
    EXPECT_EQ(quality["alignment"]["worst"].get<double>(), last.value("min_alignment"));
    EXPECT_GT(quality["orthogonality"]["worst"].get<double>(), 0);
    EXPECT_NE(history_csv(run.history()).find("max_aspect_ratio,mean_aspect_ratio"), std::string::npos);

    scenario.method.values.set("cell_quality", false);
    run.change(scenario);
    EXPECT_FALSE(run.history().back().value("max_aspect_ratio"));
    EXPECT_GE(OrderedJson::parse(summary_json(run))["cell_quality"]["aspect_ratio"]["worst"], 1.0);
    gaspard::Run interval(catalogue, find_scenario(*catalogue, "layer-1d"));
    EXPECT_TRUE(OrderedJson::parse(summary_json(interval))["cell_quality"].is_null());
}

TEST(Summary, WithoutAnIterationHasNoTimePerIteration) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    gaspard::Run run(catalogue, small_scenario(*catalogue));
    run.interrupt();
    const OrderedJson json = OrderedJson::parse(summary_json(run));
    EXPECT_EQ(json["status"], "interrupted");
    EXPECT_EQ(json["iterations"], 0);
    EXPECT_TRUE(json["seconds_per_iteration"].is_null());
    EXPECT_TRUE(json["equidistribution"].is_number());
}

TEST(History, HasARowForTheStartAndOneForEveryIteration) {
    gaspard::Run run = finished_run();
    const auto rows = split_csv(history_csv(run.history()));
    ASSERT_EQ(rows.size(), 1u + 7u);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"iteration", "residual", "equidistribution", "exact_rms",
                                                 "min_jacobian", "tangled_cells", "step_size", "seconds",
                                                 "inner_iterations", "note"}));
    for (std::size_t i = 0; i <= 6; ++i) {
        const auto& row = rows[i + 1];
        const StepReport& report = run.history()[i];
        ASSERT_EQ(row.size(), 10u);
        EXPECT_EQ(number(row[0]), static_cast<double>(i));
        EXPECT_EQ(number(row[1]), report.residual);
        EXPECT_EQ(row[3], "");
        EXPECT_EQ(number(row[6]), report.step_size);
        EXPECT_EQ(number(row[7]), report.seconds);
        const bool measured = i % 4 == 0 || i == 6; // every fourth, and the last
        for (const std::size_t column : {2u, 4u, 5u})
            EXPECT_EQ(row[column].empty(), !measured) << "row " << i;
        if (!measured) continue;
        EXPECT_EQ(number(row[2]), report.value("equidistribution"));
        EXPECT_EQ(number(row[4]), report.value("min_jacobian"));
        EXPECT_EQ(number(row[5]), 0);
    }
}

TEST(History, WritesEveryColumnItKnows) {
    StepReport report;
    report.iteration = 1234;
    report.residual = 1234.5;
    auto diagnostics = quality_series();
    for (const auto& one : exact_series()) diagnostics.push_back(one);
    report.series =
        std::make_shared<const SeriesTable>(normalised_residual(), diagnostics, std::vector<SeriesInfo>{});
    report.set("equidistribution", 0.25);
    report.set("exact_rms", 1e-9);
    report.set("min_jacobian", -0.125);
    report.tangled_cells = 5678;
    report.step_size = 0.1;
    report.seconds = 3661.75;
    report.inner_iterations = 17;
    report.note = "a \"sentence\"";
    const CommaLocale comma;
    EXPECT_EQ(split_csv(history_csv({report})).at(1),
              (std::vector<std::string>{"1234", "1234.5", "0.25", "1e-09", "-0.125", "5678", "0.1", "3661.75",
                                        "17", "\"a \"\"sentence\"\"\""}));
}

TEST(RunFiles, ThePlotOfTheResidualHasTheTolerance) {
    gaspard::Run run = finished_run();
    const TemporaryFolder folder;
    write_run_files(folder.path(), run, parse_formats("svg"));
    EXPECT_NE(read_file(folder.path() / "residual.svg").find(">tolerance 10<tspan"), std::string::npos);
    EXPECT_EQ(read_file(folder.path() / "equidistribution.svg").find("tolerance"), std::string::npos);
}

TEST(RunFiles, AreThoseOfTheContract) {
    const TemporaryFolder folder;
    gaspard::Run run = finished_run();
    write_run_files(folder.path(), run, parse_formats("obj,glb"));
    EXPECT_EQ(folder.content(), (std::vector<std::string>{"adapted.glb", "adapted.obj", "computational.obj",
                                                          "history.csv", "state.bin", "summary.json"}));
    EXPECT_EQ(read_file(folder / "history.csv"), history_csv(run.history()));
    EXPECT_EQ(OrderedJson::parse(read_file(folder / "summary.json"))["iterations"], 6);
}

TEST(RunFiles, TheSvgFollowsTheCameraOfTheView) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const auto svg_with = [&](const std::string& camera) {
        Scenario scenario = small_scenario(*catalogue, 1);
        scenario.view.set("camera", camera);
        gaspard::Run run(catalogue, scenario);
        run.step();
        const TemporaryFolder folder;
        write_run_files(folder.path(), run, parse_formats("svg"));
        return read_file(folder.path() / "adapted.svg");
    };
    EXPECT_EQ(svg_with("").find("clip-path"), std::string::npos);
    EXPECT_NE(svg_with("centre 0.1 0.1 height 0.2").find("clip-path"), std::string::npos);
}

TEST(RunFiles, TheStateGoesOnWhereTheRunEnded) {
    const TemporaryFolder folder;
    gaspard::Run run = finished_run();
    write_run_files(folder.path(), run, {});
    EXPECT_EQ(folder.content(), (std::vector<std::string>{"history.csv", "state.bin", "summary.json"}));
    const gaspard::Run next = finished_run({.start = read_state(folder / "state.bin")});
    EXPECT_EQ(next.history().front().residual, run.history().back().residual);
    EXPECT_EQ(next.state(), finished_run({}, 12).state()) << "six and six steps are twelve";
}

TEST(RunFiles, AreTheSameBytesButForTimesAndMemory) {
    const TemporaryFolder first, second;
    for (const auto* folder : {&first, &second}) {
        gaspard::Run run = finished_run();
        const CommaLocale comma;
        write_run_files(folder->path(), run, parse_formats("obj,glb"));
    }
    for (const char* name : {"adapted.glb", "adapted.obj", "computational.obj", "state.bin"})
        EXPECT_EQ(read_file(first / name), read_file(second / name)) << name;
    auto a = OrderedJson::parse(read_file(first / "summary.json")),
         b = OrderedJson::parse(read_file(second / "summary.json"));
    for (OrderedJson* json : {&a, &b})
        for (const char* key :
             {"setup_seconds", "solve_seconds", "cpu_seconds", "seconds_per_iteration", "peak_memory_bytes"})
            json->erase(key);
    EXPECT_EQ(a, b);
}

// The record first: what is interrupted leaves no files without it, which the next run would not replace.
TEST(RunFiles, BeginWithTheRecord) {
    const TemporaryFolder folder;
    gaspard::Run run = finished_run();
    std::stop_source stop;
    const auto at_the_first = [&](double, std::string_view what) {
        if (what != "writing summary.json") stop.request_stop();
    };
    EXPECT_THROW(write_run_files(folder.path(), run, {}, at_the_first, stop.get_token()), Interrupted);
    ASSERT_FALSE(folder.content().empty());
    EXPECT_NO_THROW(check_replaceable(folder.path(), run_file_names(run, {}), "summary.json", "plane-ring"));
}

TEST(RunFiles, HaveTheValuesAlongTheLineOfTheView) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = small_scenario(*catalogue, 3);
    const TemporaryFolder folder;
    {
        gaspard::Run run(catalogue, scenario);
        write_run_files(folder / "without", run, {});
        EXPECT_FALSE(std::filesystem::exists(folder / "without" / "section.csv"));
    }
    scenario.view.set("section", std::string("0 0.5 1 0.5"));
    gaspard::Run run(catalogue, scenario);
    run.solve();
    write_run_files(folder / "with", run, {});
    const auto names = run_file_names(run, {});
    EXPECT_NE(std::find(names.begin(), names.end(), "section.csv"), names.end());
    EXPECT_TRUE(read_file(folder / "with" / "section.csv").starts_with("arc_length,x,y,monitor,cell\n"));
    EXPECT_NE(read_file(folder / "with" / "section.svg").find("arc length"), std::string::npos);
}

TEST(RunFiles, MakeTheirFolder) {
    const TemporaryFolder folder;
    gaspard::Run run = finished_run();
    write_run_files(folder / "a" / "b", run, {});
    EXPECT_FALSE(read_file(folder / "a" / "b" / "summary.json").empty());
}

TEST(RunFiles, AFolderThatCannotBeMadeIsTheMachinesFault) {
    const TemporaryFolder folder;
    gaspard::Run run = finished_run();
    write_run_files(folder.path(), run, {});
    EXPECT_THROW(write_run_files(folder / "state.bin" / "below", run, {}), MachineError) << "below a file";
}

} // namespace
} // namespace gaspard
