// Long runs in time: what their history keeps, and that nothing else grows or gets lost.
#include "core/base/error.hpp"
#include "core/io/history_file.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/history_thinning.hpp"
#include "core/session/time_series.hpp"
#include "support/temporary_folder.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <numeric>
#include <sys/resource.h>

namespace gaspard {
namespace {

/// `solving` rows, then `steps` time steps.
std::vector<StepReport> history_of(int solving, int steps) {
    const auto table = std::make_shared<const SeriesTable>(SeriesInfo{.name = "residual"}, time_series(),
                                                           std::vector<SeriesInfo>{}, "residual");
    std::vector<StepReport> history;
    for (int i = 0; i < solving + steps; ++i) {
        StepReport report{.iteration = i, .inner_iterations = 1, .series = table};
        report.values.assign(table->slots(), std::numeric_limits<double>::quiet_NaN());
        if (i >= solving) report.set(time_names::iterations, 1);
        history.push_back(std::move(report));
    }
    return history;
}

std::vector<int> iterations_of(const std::vector<StepReport>& history) {
    std::vector<int> all;
    for (const StepReport& row : history) all.push_back(row.iteration);
    return all;
}

TEST(HistoryThinning, KeepsTheSolveTheFirstAndTheLastAndEverySecond) {
    auto history = history_of(3, 16);
    EXPECT_FALSE(thin_out_time_steps(history, 16));
    EXPECT_EQ(history.size(), 19u);
    history = history_of(3, 17);
    EXPECT_TRUE(thin_out_time_steps(history, 16));
    EXPECT_EQ(iterations_of(history), (std::vector<int>{0, 1, 2, 3, 4, 6, 8, 10, 12, 14, 16, 18, 19}));
    const auto inner = [](int sum, const StepReport& row) { return sum + row.inner_iterations; };
    EXPECT_EQ(std::accumulate(history.begin(), history.end(), 0, inner), 20) << "none is lost";
    EXPECT_EQ(history.back().inner_iterations, 1) << "the last may have been sent to someone";
    history = history_of(0, 5);
    EXPECT_TRUE(thin_out_time_steps(history, 2));
    EXPECT_EQ(iterations_of(history), (std::vector<int>{0, 1, 4})) << "one group between the ends";
    auto solving = history_of(100, 0);
    EXPECT_FALSE(thin_out_time_steps(solving, 16)) << "iterations are no time steps";
}

TEST(HistoryThinning, KeepsWhatIsMarkedAndMeasured) {
    auto history = history_of(1, 40);
    for (const int i : {5, 6, 26}) history[static_cast<std::size_t>(i)].tangled_cells = 0;
    history[7].note = "the time step is not solved";
    history[15].note = "the time step is not solved";
    history[16].tangled_cells = 2;
    EXPECT_TRUE(thin_out_time_steps(history, 24));
    EXPECT_EQ(iterations_of(history), (std::vector<int>{0, 1, 5, 7, 10, 16, 18, 22, 26, 30, 34, 38, 40}));
}

TEST(HistoryThinning, IsBoundedHoweverManyAreMarked) {
    auto all = history_of(1, 3000);
    for (StepReport& row : all) row.tangled_cells = 1;
    std::vector<StepReport> history;
    for (const StepReport& row : all) {
        history.push_back(row);
        thin_out_time_steps(history, 64);
        ASSERT_LE(history.size(), 65u);
        ASSERT_EQ(history.back().iteration, row.iteration);
    }
    EXPECT_GT(history.size(), 16u);
    EXPECT_EQ(history[1].iteration, 1);
}

/// In a child process: a history larger than files may be, then a small file beside it.
[[noreturn]] void write_a_history_beyond_the_limit(const std::filesystem::path& folder) {
    std::signal(SIGXFSZ, SIG_IGN); // as in run_command_line
    const rlimit limit{100'000, 100'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario, {"domain.cells=8", "method.interpolation=false"});
    gaspard::Run run(catalogue, scenario);
    HistoryFile file(folder / "history.csv", run);
    for (int i = 0; i < 5000; ++i) file.add(run.history().front());
    const auto left = std::filesystem::directory_iterator(folder);
    std::fputs(left == end(left) ? "nothing is left; " : "a file is left; ", stderr);
    try {
        file.finish(run);
    } catch (const MachineError& error) {
        std::fputs(error.what(), stderr);
        std::_Exit(0);
    }
    std::_Exit(1);
}

TEST(HistoryFileDeathTest, LeavesTheDiskToOtherFilesIfItIsFull) {
    const TemporaryFolder folder;
    EXPECT_EXIT(write_a_history_beyond_the_limit(folder.path()), testing::ExitedWithCode(0),
                "nothing is left; cannot write .*/history.csv: File too large");
}

class LongRunTest : public testing::Test {
  protected:
    Scenario scenario() {
        Scenario result = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, result,
                       {"method.type=newton", "domain.cells=8", "monitor.amplitude=0.5", "time.end=10",
                        "time.step=1e-3", "method.diagnostics_every=5", "method.interpolation=false"});
        return result;
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(LongRunTest, TheHistoryIsBoundedAndTheFileHasEveryRow) {
    const TemporaryFolder folder;
    gaspard::Run run(catalogue, scenario());
    HistoryFile file(folder / "history.csv", run);
    int measured = 0;
    while (run.status() == RunStatus::running) {
        file.add(run.step());
        ASSERT_LE(run.history().size(), most_time_steps + 20);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "history.csv")) << "until it is finished";
    file.finish(run);
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_LT(run.history().size(), 6500u);
    for (const StepReport& row : run.history()) measured += row.measured() ? 1 : 0;
    EXPECT_GT(measured, 500) << "of 2000";
    std::ifstream lines(folder / "history.csv");
    int expected = -1;
    for (std::string line; std::getline(lines, line); ++expected)
        if (expected >= 0) {
            ASSERT_EQ(line.substr(0, line.find(',')), std::to_string(expected));
        }
    EXPECT_EQ(expected, run.history().back().iteration + 1);
    EXPECT_GT(expected, 10000);
}

} // namespace
} // namespace gaspard
