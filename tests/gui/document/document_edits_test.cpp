// Undo and redo of a document: what becomes an edit, and what it restores.
#include "gui/document_fixture.hpp"

#include <atomic>
#include <thread>

namespace gaspard {
namespace {

class DocumentEditsTest : public DocumentFixture {
  protected:
    void open_and_solve() {
        document.open(small_ring());
        ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    }
    void set_amplitude(double amplitude) {
        Scenario changed = run().scenario;
        set_value(*catalogue, changed, "monitor.amplitude", amplitude);
        document.change(run().id, changed);
    }
    double amplitude() { return run().scenario.monitor.values.real("amplitude"); }
    /// What the solver itself works with, once it has answered.
    double solved_amplitude() {
        EXPECT_TRUE(wait_until([&] { return run().changes.settled(); }));
        return run().status.scenario->monitor.values.real("amplitude");
    }
    Values& view() { return document.viewports().front().view; }
    std::size_t undo_count() const { return document.edits().undo_count(); }
};

TEST_F(DocumentEditsTest, AChangeOfValuesIsUndoneAndRedoneByTheSolver) {
    open_and_solve();
    EXPECT_FALSE(document.undo());
    set_amplitude(20);
    EXPECT_EQ(solved_amplitude(), 20);
    EXPECT_EQ(document.edits().undo_label(), "amplitude");
    EXPECT_TRUE(document.undo());
    EXPECT_EQ(amplitude(), 10);
    EXPECT_EQ(run().name, "Ring");
    EXPECT_EQ(solved_amplitude(), 10);
    EXPECT_FALSE(document.undo());
    EXPECT_TRUE(document.redo());
    EXPECT_EQ(run().name, "Ring, Amplitude A = 20");
    EXPECT_EQ(solved_amplitude(), 20);
    EXPECT_FALSE(document.redo());
    ASSERT_TRUE(wait_until([&] { return run().ended(); })) << "a change continues a run that had ended";
}

TEST_F(DocumentEditsTest, ChangesOfOneGestureAreOneEdit) {
    open_and_solve();
    for (const double value : {11.0, 12.0, 13.0}) set_amplitude(value);
    document.end_gesture();
    for (const double value : {14.0, 15.0}) set_amplitude(value);
    document.end_gesture();
    EXPECT_EQ(undo_count(), 2U);
    document.undo();
    EXPECT_EQ(amplitude(), 13);
    document.undo();
    EXPECT_EQ(solved_amplitude(), 10);
    set_amplitude(30);
    EXPECT_FALSE(document.redo()) << "a new edit clears the ones to redo";
}

TEST_F(DocumentEditsTest, OtherRowsAreAnotherEdit) {
    open_and_solve();
    set_amplitude(20);
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.radius", 0.3);
    document.change(run().id, changed);
    changed.monitor = monitor_section(*catalogue, "bell");
    document.change(run().id, changed);
    EXPECT_EQ(undo_count(), 3U);
    EXPECT_EQ(document.edits().undo_label(), "monitor type");
    document.undo();
    EXPECT_EQ(document.edits().undo_label(), "radius");
    EXPECT_EQ(document.edits().redo_label(), "monitor type");
    EXPECT_EQ(run().scenario.monitor.type, "ring");
    EXPECT_EQ(run().scenario.monitor.values.real("radius"), 0.3);
    document.undo(), document.undo();
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().scenario, small_ring());
    EXPECT_EQ(run().status.scenario->monitor, small_ring().monitor);
}

TEST_F(DocumentEditsTest, RefusedValuesLeaveNoEdit) {
    open_and_solve();
    set_amplitude(20);
    EXPECT_EQ(solved_amplitude(), 20);
    document.end_gesture();
    Scenario impossible = run().scenario;
    impossible.method.type = "magic";
    document.change(run().id, impossible);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_TRUE(run().status.refused);
    EXPECT_EQ(run().scenario.method, small_ring().method);
    EXPECT_EQ(undo_count(), 1U);
    EXPECT_EQ(document.edits().undo_label(), "amplitude");
    document.undo();
    EXPECT_EQ(solved_amplitude(), 10);
}

TEST_F(DocumentEditsTest, AnUndoThatTheSolverRefusesIsTakenBack) {
    Scenario impossible = small_ring(); // the first values of a run can be wrong, as of a file that has gone
    open_and_solve();
    impossible.method.type = "magic";
    run().scenario = impossible;
    document.change(run().id, small_ring());
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    document.end_gesture();
    set_amplitude(20);
    EXPECT_EQ(solved_amplitude(), 20);
    document.undo();
    EXPECT_EQ(solved_amplitude(), 10);
    document.undo();
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_TRUE(run().status.refused);
    EXPECT_EQ(run().scenario, small_ring()) << "the last valid values";
    EXPECT_EQ(undo_count(), 1U) << "the edit is still there to be undone";
    EXPECT_EQ(document.edits().redo_label(), "amplitude");
    document.redo();
    EXPECT_EQ(solved_amplitude(), 20);
}

TEST_F(DocumentEditsTest, OpeningAScenarioIsUndone) {
    open_and_solve();
    set_amplitude(20);
    document.end_gesture();
    view().set("color", std::string("area"));
    view().set("theme", std::string("light"));
    Scenario bell = find_scenario(*catalogue, "plane-bell");
    set_value(*catalogue, bell, "domain.cells", std::int64_t{8});
    document.replace(run().id, bell);
    ASSERT_TRUE(wait_until([&] { return run().openings == 1 && run().ended(); }));
    EXPECT_EQ(run().opened, bell);
    EXPECT_EQ(view().text("color"), "monitor");
    EXPECT_EQ(view().text("theme"), "light") << "the scenario does not set one";
    EXPECT_EQ(document.edits().undo_label(), "open " + bell.title);

    document.undo();
    EXPECT_EQ(run().opened, bell) << "until the solver has accepted the scenario";
    ASSERT_TRUE(wait_until([&] { return run().openings == 2; }));
    EXPECT_EQ(run().opened, small_ring());
    EXPECT_EQ(run().title, small_ring().title + " (modified)") << "its amplitude is";
    EXPECT_EQ(amplitude(), 20);
    EXPECT_EQ(view().text("color"), "area");
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_EQ(run().history.front().iteration, 0) << "it starts over";
    EXPECT_EQ(solved_amplitude(), 20);

    document.redo();
    ASSERT_TRUE(wait_until([&] { return run().openings == 3; }));
    EXPECT_EQ(run().opened, bell);
    EXPECT_EQ(view().text("color"), "monitor");
    EXPECT_FALSE(document.edits().can_redo());
}

TEST_F(DocumentEditsTest, UndoGoesOnWhileAScenarioIsOnItsWay) {
    open_and_solve();
    set_amplitude(20);
    const Scenario bell = find_scenario(*catalogue, "plane-bell");
    document.replace(run().id, bell);
    ASSERT_TRUE(wait_until([&] { return run().openings == 1; }));
    document.undo(), document.undo(); // the solver has not answered the first one
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().opened, small_ring());
    EXPECT_EQ(run().scenario, small_ring());
    EXPECT_EQ(run().status.scenario->monitor, small_ring().monitor);
    EXPECT_FALSE(document.edits().can_undo());
    document.redo(), document.redo();
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().opened, bell);
    EXPECT_EQ(run().scenario.monitor, bell.monitor);
}

TEST_F(DocumentEditsTest, RunsOfAnotherProblemAreHiddenUntilTheirsIsBack) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const DocumentRun& kept = *document.runs().find(*document.keep(run().id));
    const DocumentRun& hidden = *document.runs().find(*document.keep(run().id));
    document.hide(hidden.id, true);
    Scenario other = run().scenario;
    set_value(*catalogue, other, "monitor.amplitude", 12.0);
    document.change(run().id, other);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_FALSE(run().earlier.empty());
    EXPECT_FALSE(kept.hidden) << "other values can be compared";

    const Scenario bell = find_scenario(*catalogue, "plane-bell");
    document.replace(run().id, bell);
    ASSERT_TRUE(wait_until([&] { return run().openings == 1 && run().history.size() > 1; }));
    EXPECT_TRUE(kept.hidden);
    EXPECT_TRUE(kept.set_aside);
    EXPECT_FALSE(hidden.set_aside) << "it was hidden on purpose";
    EXPECT_TRUE(run().earlier.empty()) << "so are the solves before";

    document.undo();
    ASSERT_TRUE(wait_until([&] { return run().openings == 2; }));
    EXPECT_FALSE(kept.hidden);
    EXPECT_TRUE(hidden.hidden);

    document.replace(run().id, bell);
    ASSERT_TRUE(wait_until([&] { return run().openings == 3; }));
    document.hide(kept.id, false); // on purpose, too
    EXPECT_FALSE(kept.set_aside);
    document.undo(), document.undo();
    ASSERT_TRUE(wait_until([&] { return run().openings == 4; }));
    EXPECT_FALSE(kept.set_aside);
}

TEST_F(DocumentEditsTest, EarlierSolvesOfAnotherMonitorGo) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    Scenario other = run().scenario;
    set_value(*catalogue, other, "monitor.amplitude", 12.0);
    document.change(run().id, other);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    ASSERT_EQ(run().earlier.size(), 1U);
    apply_settings(*catalogue, other, {"monitor.type=bell"});
    document.change(run().id, other);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_TRUE(run().earlier.empty());
}

TEST_F(DocumentEditsTest, ARedoSupersedesTheOpeningThatUndoHasAskedFor) {
    open_and_solve();
    const Scenario bell = find_scenario(*catalogue, "plane-bell");
    document.replace(run().id, bell);
    ASSERT_TRUE(wait_until([&] { return run().openings == 1; }));
    std::atomic<int> gate = 0; // keeps the solver from working ahead, and the two changes apart
    const auto hold_until = [&](int step) {
        run().solver->post(InspectCommand{[&gate, step](gaspard::Run&, const Activity&) {
            while (gate < step) std::this_thread::yield();
        }});
    };
    hold_until(1);
    document.undo();
    hold_until(2);
    document.redo();
    const std::uint64_t undone = run().changes.asked - 1;
    gate = 1;
    EXPECT_TRUE(wait_until([&] { return run().changes.answered >= undone; }));
    gate = 2;
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().opened, bell);
    EXPECT_EQ(run().title, bell.title);
    EXPECT_EQ(run().scenario.monitor, bell.monitor);
    EXPECT_EQ(run().status.scenario->monitor, bell.monitor);
    EXPECT_FALSE(document.edits().can_redo());
}

TEST_F(DocumentEditsTest, AViewChangedWhileAnOpeningIsUndoneIsNoEdit) {
    open_and_solve();
    document.replace(run().id, find_scenario(*catalogue, "plane-bell"));
    ASSERT_TRUE(wait_until([&] { return run().openings == 1; }));
    std::atomic<bool> open = false;
    run().solver->post(InspectCommand{[&open](gaspard::Run&, const Activity&) {
        while (!open) std::this_thread::yield();
    }});
    document.undo();
    view().set("color", std::string("area"));
    document.record_views();
    EXPECT_TRUE(document.edits().can_redo());
    open = true;
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    document.record_views();
    EXPECT_EQ(view().text("color"), "monitor") << "the view of the scenario that is restored";
    EXPECT_EQ(undo_count(), 0U);
    EXPECT_TRUE(document.edits().can_redo());
}

TEST_F(DocumentEditsTest, AChangeOfValuesSupersedesAnOpening) {
    open_and_solve();
    std::atomic<bool> open = false;
    run().solver->post(InspectCommand{[&open](gaspard::Run&, const Activity&) {
        while (!open) std::this_thread::yield();
    }});
    document.replace(run().id, find_scenario(*catalogue, "plane-bell"));
    run().solver->post(InspectCommand{[](gaspard::Run&, const Activity&) {}});
    set_amplitude(20);
    open = true;
    EXPECT_EQ(solved_amplitude(), 20);
    EXPECT_EQ(run().opened, small_ring());
    EXPECT_EQ(run().scenario.monitor, run().status.scenario->monitor);
}

TEST_F(DocumentEditsTest, ARefusedOpeningLeavesNoEdit) {
    open_and_solve();
    Scenario wrong = small_ring();
    wrong.method.type = "magic";
    document.replace(run().id, wrong);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(undo_count(), 0U);
    EXPECT_EQ(run().opened, small_ring());
}

TEST_F(DocumentEditsTest, ChangesOfAViewAreEditsButThePickIsNot) {
    open_and_solve();
    view().set("pick", std::string("cell 3"));
    document.record_views();
    EXPECT_EQ(undo_count(), 0U);
    view().set("color", std::string("area"));
    document.record_views();
    EXPECT_EQ(document.edits().undo_label(), "colour by");
    view().set("pick", std::string("cell 5"));
    view().set("layout", std::string("side-by-side"));
    document.record_views();
    EXPECT_EQ(undo_count(), 2U);
    document.undo(), document.undo();
    EXPECT_EQ(view().text("color"), "monitor");
    EXPECT_EQ(view().text("layout"), "single");
    EXPECT_EQ(view().text("pick"), "cell 5") << "not part of an edit";
    document.record_views();
    EXPECT_TRUE(document.edits().can_redo()) << "undo itself is not recorded";
    document.redo();
    EXPECT_EQ(view().text("color"), "area");
    EXPECT_EQ(run().changes.asked, 0U) << "the solver need not know";
}

TEST_F(DocumentEditsTest, UndoFindsWhatWasNotRecordedYet) {
    open_and_solve();
    view().set("lines", false);
    EXPECT_TRUE(document.undo());
    EXPECT_TRUE(view().boolean("lines"));
}

TEST_F(DocumentEditsTest, UndoOfAnotherDomainEndsThePick) {
    open_and_solve();
    Scenario finer = run().scenario;
    set_value(*catalogue, finer, "domain.cells", std::int64_t{16});
    document.change(run().id, finer);
    view().set("pick", std::string("cell 200"));
    document.undo();
    EXPECT_EQ(view().text("pick"), "") << "there is no such cell any more";
}

TEST_F(DocumentEditsTest, KeepingAndRemovingARunAreUndone) {
    open_and_solve();
    const RunId first = *document.keep(run().id);
    ASSERT_TRUE(document.keep(run().id));
    const DocumentRun* kept = document.runs().find(first);
    const std::size_t colour = kept->colour, points = kept->curves.find("residual")->trace.values.size();
    const auto snapshot = kept->snapshot;
    document.viewports().push_back({.run = first, .view = run().scenario.view});
    document.remove(first);
    EXPECT_EQ(document.edits().undo_label(), "remove Ring");
    EXPECT_EQ(document.viewports()[1].run, document.active().id);

    EXPECT_TRUE(document.undo());
    ASSERT_EQ(document.runs().size(), 3U);
    EXPECT_EQ(&document.runs()[1], kept) << "the same run at the same place";
    EXPECT_EQ(kept->id, first);
    EXPECT_EQ(kept->name, "Ring");
    EXPECT_EQ(kept->colour, colour);
    EXPECT_EQ(kept->snapshot, snapshot);
    EXPECT_EQ(kept->curves.find("residual")->trace.values.size(), points);
    EXPECT_EQ(document.viewports()[1].run, first) << "its viewport shows it again";

    document.undo(), document.undo();
    EXPECT_EQ(document.runs().size(), 1U) << "nothing was kept";
    EXPECT_FALSE(document.undo());
    document.redo(), document.redo();
    ASSERT_EQ(document.runs().size(), 3U);
    EXPECT_EQ(document.runs()[1].id, first);
    document.redo();
    EXPECT_EQ(document.runs().find(first), nullptr);
}

TEST_F(DocumentEditsTest, RenamingAndHidingARunAreUndone) {
    open_and_solve();
    const RunId id = *document.keep(run().id);
    const DocumentRun& kept = *document.runs().find(id);
    document.end_gesture();
    for (const char* name : {"Ring s", "Ring st", "Ring start"}) document.rename(id, name);
    document.end_gesture();
    document.hide(id, true);
    document.hide(run().id, true);
    EXPECT_EQ(undo_count(), 4U);
    document.undo();
    EXPECT_FALSE(run().hidden);
    EXPECT_EQ(document.edits().undo_label(), "hide Ring start");
    document.undo();
    EXPECT_FALSE(kept.hidden);
    EXPECT_EQ(document.edits().undo_label(), "rename to Ring start");
    document.undo();
    EXPECT_EQ(kept.name, "Ring");
    document.redo(), document.redo();
    EXPECT_EQ(kept.name, "Ring start");
    EXPECT_TRUE(kept.hidden);
}

TEST_F(DocumentEditsTest, ComparisonsAndSteppingAreNoEdits) {
    document.open(endless_ring());
    ASSERT_TRUE(wait_until([&] { return run().solving(); }));
    document.step(run().id), document.reset(run().id), document.start(run().id);
    document.compare({"relaxation"});
    ASSERT_TRUE(
        wait_until([&] { return document.runs().size() == 2 && !document.runs()[1].history.empty(); }));
    document.cancel_comparison();
    EXPECT_FALSE(document.edits().can_undo());

    const RunId compared = document.runs()[1].id;
    document.hide(compared, true);
    document.remove(compared);
    document.undo();
    ASSERT_EQ(document.runs().size(), 2U);
    EXPECT_EQ(document.comparison().rows().size(), 1U) << "the table has its row again";
    document.redo();
    document.compare({"relaxation"});
    EXPECT_FALSE(document.edits().can_undo()) << "edits of runs that are gone for good are dropped";
    EXPECT_FALSE(document.edits().can_redo());
    document.cancel_comparison();
}

/// A square patch as the text of domain.file.
std::string square_patch(int side) {
    const std::string a = std::to_string(side);
    return R"({"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],"control_points":[[0,0],[)" + a + ",0],[0," + a +
           "],[" + a + "," + a + "]]}";
}

// The window changes the name of a file; the solver reads it, and monitors fit the patch for both.
TEST_F(DocumentEditsTest, MonitorsFitAnotherFileOnceTheSolverHasReadIt) {
    Scenario opened = find_scenario(*catalogue, "spline-circle");
    apply_settings(*catalogue, opened,
                   {"domain.type=spline-patch", "domain.file=" + square_patch(1), "domain.cells=8",
                    "monitor.radius=0.2"});
    document.open(opened);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    Scenario changed = run().scenario;
    changed.domain.values.set("file", square_patch(50));
    update_rows(*catalogue, changed); // as the panel does, which does not read
    EXPECT_EQ(changed.monitor.values.real("radius"), 0.2);
    document.change(run().id, changed);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_TRUE(is_located(*catalogue, run().scenario));
    EXPECT_EQ(run().scenario.monitor.values.real("radius"), 10);
    EXPECT_EQ(run().status.scenario->monitor, run().scenario.monitor) << "the solver has the same values";
    EXPECT_TRUE(document.undo());
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().scenario.monitor.values.real("radius"), 0.2);
    EXPECT_TRUE(document.redo());
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().scenario.monitor.values.real("radius"), 10);
}

} // namespace
} // namespace gaspard
