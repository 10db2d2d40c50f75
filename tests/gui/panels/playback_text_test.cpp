// What the viewport and the bar below it say of a run.
#include "core/scenario/toml.hpp"
#include "core/session/recording.hpp"
#include "core/session/run.hpp"
#include "gui/panels/playback_bar.hpp"
#include "gui/panels/viewport_pane.hpp"
#include "gui/run_fixtures.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(TitleAmongOthers, SaysTheTimeOfTheNewestMesh) {
    DocumentRun run;
    run.name = "Ring";
    run.status.run = RunStatus::running;
    run.history = made_up_time_steps(0);
    run.history.back().iteration = 1;
    EXPECT_EQ(title_among_others({&run, nullptr}), "Ring: 1 iteration, running");
    run.history = made_up_time_steps(199);
    EXPECT_EQ(title_among_others({&run, nullptr}), "Ring: t = 9.95, running");
    run.history.back().tangled_cells = 3;
    EXPECT_EQ(title_among_others({&run, nullptr}), "Ring: t = 9.95, 3 tangled cells, running");
}

TEST(RecordingText, SaysHowManyIteratesAreKeptAndTheirMemory) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    gaspard::Run solved(catalogue, find_scenario(*catalogue, "plane-ring"));
    Snapshot snapshot = *solved.snapshot();
    DocumentRuns runs;
    DocumentRun& run = runs.push_back(made_up_run("Ring", 27));
    run.recording = std::make_shared<Recording>(recording_memory);
    for (int i = 0; i <= 27; ++i) snapshot.report.iteration = i, run.recording->add(snapshot);
    const std::size_t all = recorded_bytes(runs);
    EXPECT_EQ(all, run.recording->bytes());
    EXPECT_GT(all, std::size_t{1} << 20U);
    const std::string memory = std::to_string(all >> 20U) + " of 512 MB for all runs";
    EXPECT_EQ(recording_text(run, all), "Recorded: 28 of 28 iterates\n" + memory);
    run.recording->set_budget(all / 3);
    EXPECT_EQ(run.recording->stride(), 4);
    EXPECT_EQ(recording_text(run, 0),
              "Recorded: 8 of 28 iterates, one of every 4\nless than 1 of 512 MB for all runs");
}

} // namespace
} // namespace gaspard
