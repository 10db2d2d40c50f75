#include "core/session/history_thinning.hpp"
#include "core/session/time_series.hpp"
#include "gui/document/playback.hpp"
#include "gui/document_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>

namespace gaspard {
namespace {

constexpr double frame = 1.0 / 60;

class PlaybackTest : public DocumentFixture {
  protected:
    /// A solve of 40 iterations that has ended.
    void solve() {
        document.open(small_ring());
        ASSERT_TRUE(wait_until([&] { return run().ended(); }));
        playback.update(run(), frame);
        ASSERT_EQ(run().history.back().iteration, 40);
    }
    int shown() { return playback.snapshot(run())->report.iteration; }
    void play_for(double seconds) {
        for (double t = 0; t < seconds; t += frame) playback.update(run(), frame);
    }

    Playback playback;
};

/// A ring that moves.
class PlaybackInTimeTest : public PlaybackTest {
  protected:
    void open(const std::string& step, const std::string& end) {
        Scenario moving = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, moving,
                       {"domain.cells=8", "method.type=newton", "time.end=" + end, "time.step=" + step,
                        "time.monitor.center_x=center_x + t/8"});
        document.open(moving);
        ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    }
    const DocumentRun& keep() { return *document.runs().find(*document.keep(run().id)); }
    /// The run is solved with other steps.
    void change(const std::string& step, const std::string& end) {
        Scenario other = run().scenario;
        apply_settings(*catalogue, other, {"time.end=" + end, "time.step=" + step});
        document.change(run().id, other);
        ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
        document.reset(run().id);
        ASSERT_TRUE(wait_until([&] { return time_of(run().history.front()) == 0.0 && !run().ended(); }));
        document.start(run().id);
        ASSERT_TRUE(wait_until([&] { return run().ended(); }));
        ASSERT_EQ(time_of(run().history.front()), 0.0);
    }
    static int first_step(const DocumentRun& of) {
        return std::ranges::find_if(of.history, is_time_step)->iteration;
    }
    void go_to(const DocumentRun& of, double t) {
        for (const StepReport& row : of.history)
            if (std::abs(*time_of(row) - t) < 1e-9) playback.go_to(of, row.iteration);
    }
    double shown_time(const DocumentRun& of) {
        return *time_of(of.history.at(static_cast<std::size_t>(playback.iteration(of))));
    }
};

TEST_F(PlaybackTest, ShowsTheNewestIterateUntilToldOtherwise) {
    solve();
    EXPECT_TRUE(playback.live());
    EXPECT_EQ(playback.snapshot(run()), run().snapshot);
    EXPECT_EQ(playback.iteration(run()), 40);
}

TEST_F(PlaybackTest, GoesToAnyIterateAndByOne) {
    solve();
    playback.go_to(run(), 12.4);
    EXPECT_FALSE(playback.live());
    EXPECT_EQ(shown(), 12);
    EXPECT_EQ(playback.iteration(run()), 12);
    const auto snapshot = playback.snapshot(run());
    EXPECT_EQ(playback.snapshot(run()), snapshot) << "restored once";
    playback.go_back(run());
    EXPECT_EQ(shown(), 11);
    playback.go_forward(run());
    playback.go_forward(run());
    EXPECT_EQ(shown(), 13);
    playback.go_to_start(run());
    EXPECT_EQ(shown(), 0);
    playback.go_back(run());
    EXPECT_EQ(shown(), 0) << "there is none before it";
    playback.go_to(run(), -1e300);
    EXPECT_EQ(shown(), 0);
    playback.go_to(run(), 39);
    playback.go_forward(run());
    EXPECT_TRUE(playback.live()) << "the last one is the newest";
    playback.go_to(run(), 1e300);
    EXPECT_TRUE(playback.live());
}

TEST_F(PlaybackTest, ReplaysAtItsRateAndEndsLive) {
    solve();
    playback.set_rate(10);
    playback.play(run());
    EXPECT_TRUE(playback.playing());
    EXPECT_EQ(shown(), 0) << "from the start, as the newest was shown";
    play_for(1);
    EXPECT_NEAR(shown(), 10, 1);
    playback.pause();
    const int here = shown();
    play_for(1);
    EXPECT_EQ(shown(), here);
    playback.play(run());
    EXPECT_EQ(shown(), here) << "it goes on from where it stands";
    playback.set_rate(30);
    play_for(2);
    EXPECT_TRUE(playback.live());
    EXPECT_FALSE(playback.playing());
}

TEST_F(PlaybackTest, AsFastAsFramesAreDrawnIsOneIteratePerFrame) {
    solve();
    playback.set_rate(0);
    playback.play(run());
    for (int i = 1; i < 40; ++i) {
        playback.update(run(), frame);
        ASSERT_EQ(shown(), i);
        ASSERT_TRUE(playback.playing());
    }
    playback.update(run(), frame);
    EXPECT_TRUE(playback.live());
}

TEST_F(PlaybackTest, ALoopRestsAtTheEndAndBeginsAgain) {
    solve();
    playback.set_loops(true);
    playback.set_rate(100);
    playback.play(run());
    play_for(0.5);
    EXPECT_EQ(shown(), 40);
    EXPECT_TRUE(playback.playing());
    play_for(0.85);
    EXPECT_LT(shown(), 40);
    EXPECT_TRUE(playback.playing());
}

TEST_F(PlaybackTest, ASlowFrameDoesNotMakeItJump) {
    solve();
    playback.play(run());
    playback.update(run(), 10); // the window was hidden
    EXPECT_LE(shown(), 3);
}

TEST_F(PlaybackTest, ANewHistoryIsShownLive) {
    solve();
    playback.go_to(run(), 5);
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 12.0);
    document.change(run().id, changed);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    playback.update(run(), frame);
    EXPECT_TRUE(playback.live());
    playback.go_to(run(), 0);
    EXPECT_EQ(shown(), 0);
    EXPECT_NE(playback.snapshot(run())->x, playback.snapshot(run())->mesh->nodes)
        << "the solve of the new values starts from the old mesh";
}

TEST_F(PlaybackTest, KeptRunsStandAtTheSameIterationOrTheirLast) {
    solve();
    const DocumentRun& kept = *document.runs().find(*document.keep(run().id));
    playback.go_to(run(), 7);
    EXPECT_EQ(playback.snapshot(kept)->report.iteration, 7);
    EXPECT_EQ(playback.snapshot(kept)->x, playback.snapshot(run())->x);
    playback.go_to_end();
    EXPECT_EQ(playback.snapshot(kept), kept.snapshot);
}

TEST_F(PlaybackTest, TheLongestRunIsReplayedWhileShorterOnesStayAtTheirEnd) {
    solve();
    const DocumentRun& kept = *document.runs().find(*document.keep(run().id)); // 40 iterations
    Scenario shorter = run().scenario;
    set_value(*catalogue, shorter, "method.max_iterations", std::int64_t{15});
    document.change(run().id, shorter);
    document.reset(run().id);
    document.start(run().id);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    ASSERT_EQ(last_iteration(run()), 15);
    EXPECT_EQ(&longest_run(run(), {&kept}), &kept);
    EXPECT_EQ(&longest_run(run(), {}), &run());
    playback.update(run(), kept, frame);
    playback.go_to(kept, 30);
    EXPECT_EQ(playback.iteration(kept), 30);
    EXPECT_EQ(playback.iteration(run()), 15);
    EXPECT_EQ(playback.snapshot(run())->report.iteration, 15);
    playback.set_rate(10);
    playback.play(kept);
    for (int i = 0; i < 30; ++i) playback.update(run(), kept, frame);
    EXPECT_NEAR(playback.iteration(kept), 35, 1);
    EXPECT_EQ(playback.iteration(run()), 15);
    playback.go_to(kept, 40);
    EXPECT_TRUE(playback.live());
}

TEST_F(PlaybackInTimeTest, RunsWithOtherTimeStepsStandAtTheNearestTime) {
    open("0.25", "1");
    const DocumentRun& coarse = keep();
    change("0.1", "1");
    EXPECT_EQ(&longest_run(run(), {&coarse}), &run()) << "of equal ends the one with more steps";
    playback.update(run(), run(), frame);
    for (const auto& [t, nearest] : {std::pair(0.1, 0.0), {0.2, 0.25}, {0.4, 0.5}, {0.9, 1.0}}) {
        go_to(run(), t);
        EXPECT_NEAR(shown_time(run()), t, 1e-9);
        EXPECT_NEAR(shown_time(coarse), nearest, 1e-9);
        EXPECT_NEAR(*time_of(playback.snapshot(coarse)->report), nearest, 1e-9) << "its mesh as well";
    }
    go_to(run(), 0.0); // the last of the solve for the first time
    const int solved = first_step(coarse) - 1;
    EXPECT_EQ(playback.iteration(coarse), solved) << "its solved mesh, too";
    playback.go_to(run(), 0);
    EXPECT_EQ(playback.iteration(coarse), 0) << "before time passes, the iterations are compared";
    EXPECT_EQ(iteration_beside(run(), coarse, 1000000), 1000000) << "there is no such iterate";
}

TEST_F(PlaybackInTimeTest, TimesAreRightWhereTheHistoryIsThinnedOut) {
    open("0.05", "1");
    DocumentRun thinned;
    thinned.history = run().history, thinned.recording = run().recording;
    ASSERT_TRUE(thin_out_time_steps(thinned.history, 6));
    ASSERT_LT(thinned.history.size(), run().history.size() - 10);
    for (const StepReport& row : run().history)
        EXPECT_EQ(time_at(thinned, row.iteration), time_of(row)) << row.iteration << ", as recorded";
    thinned.recording.reset();
    for (const StepReport& row : run().history)
        EXPECT_NEAR(*time_at(thinned, row.iteration), *time_of(row), 1e-12)
            << row.iteration << ", between rows";
    EXPECT_FALSE(time_at(thinned, last_iteration(run()) + 1));
}

TEST_F(PlaybackInTimeTest, TheRunThatEndsLastIsReplayed) {
    open("0.25", "2");
    const DocumentRun& later = keep(); // fewer iterations
    change("0.05", "1");
    ASSERT_GT(last_iteration(run()), last_iteration(later));
    EXPECT_EQ(&longest_run(run(), {&later}), &later);
    playback.update(run(), later, frame);
    go_to(later, 0.5);
    EXPECT_NEAR(shown_time(run()), 0.5, 1e-9);
    go_to(later, 1.75);
    EXPECT_EQ(shown_time(run()), 1.0) << "it has ended";
    EXPECT_NEAR(shown_time(later), 1.75, 1e-9);
    go_to(run(), 0.65); // as to its first tangled iterate
    EXPECT_NEAR(shown_time(later), 0.75, 1e-9);
    playback.set_rate(10);
    playback.play(later);
    for (int i = 0; i < 9; ++i) playback.update(run(), later, frame);
    EXPECT_NEAR(shown_time(later), 1.0, 1e-9) << "from there, in steps of the run that is replayed";
    EXPECT_NEAR(shown_time(run()), 1.0, 1e-9);
}

TEST_F(PlaybackInTimeTest, TheEndOfAShorterRunIsATimeOfTheLongerOne) {
    open("0.25", "2");
    const DocumentRun& later = keep();
    change("0.1", "1");
    playback.update(run(), later, frame);
    playback.go_to(run(), last_iteration(run()), &later);
    playback.update(run(), later, frame);
    EXPECT_FALSE(playback.live());
    EXPECT_NEAR(shown_time(run()), 1.0, 1e-9);
    EXPECT_NEAR(shown_time(later), 1.0, 1e-9);
    playback.go_forward(later);
    EXPECT_NEAR(shown_time(later), 1.25, 1e-9);
    playback.go_to(run(), last_iteration(run()));
    EXPECT_TRUE(playback.live()) << "alone";
}

TEST_F(PlaybackInTimeTest, WhileARunGoesOnOthersAreShownAtItsTime) {
    open("0.25", "1");
    const DocumentRun& coarse = keep();
    change("0.1", "1");
    const auto from = run().recording->with_state(first_step(run()) + 4);
    ASSERT_TRUE(from);
    document.go_on_from(run().id, *from);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().history.size() == 1; }));
    playback.update(run(), coarse, frame);
    ASSERT_TRUE(playback.live());
    const double here = *time_of(from->report());
    EXPECT_LE(std::abs(shown_time(coarse) - here), 0.125 + 1e-9);
    EXPECT_LT(here, 0.6);
    document.start(run().id);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    playback.update(run(), coarse, frame);
    EXPECT_EQ(playback.snapshot(coarse), coarse.snapshot);
}

TEST_F(PlaybackTest, AFinishedRunWithoutARecordingStaysAsItIs) {
    solve();
    DocumentRun finished;
    finished.id = RunId{99};
    finished.history = run().history;
    finished.snapshot = run().snapshot;
    playback.update(finished, frame);
    playback.play(finished);
    EXPECT_FALSE(playback.playing());
    playback.go_to(finished, 3);
    playback.go_back(finished);
    EXPECT_EQ(playback.snapshot(finished), run().snapshot);
}

TEST(Playback, TheBlendGoesBackAndForth) {
    Playback playback;
    DocumentRun run;
    playback.set_blends(true);
    EXPECT_EQ(playback.blend(), 1);
    double least = 1, most = 0;
    for (int i = 0; i < 240; ++i) {
        playback.update(run, frame);
        if (i == 120) most = 0;
        least = std::min(least, playback.blend()), most = std::max(most, playback.blend());
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(most, 1);
}

TEST(TangledRanges, AreTheIterationsWhoseMeshesAreTangled) {
    std::vector<StepReport> history;
    const auto add = [&](std::optional<std::size_t> tangled) {
        history.push_back({.iteration = static_cast<int>(history.size()), .tangled_cells = tangled});
    };
    for (const auto& tangled : {std::optional<std::size_t>(0), {}, {3}, {}, {2}, {0}, {}, {1}}) add(tangled);
    const std::vector<std::pair<int, int>> expected{{2, 4}, {7, 7}};
    EXPECT_EQ(tangled_ranges(history), expected);
    EXPECT_TRUE(tangled_ranges({}).empty());
}

} // namespace
} // namespace gaspard
