// The data of a window: runs, viewports that show them, and the edits that undo takes back. A document
// belongs to the window's thread; only the solver of a run has a thread of its own.
//
// Edits are the changes of values of a live run, the opening of another scenario in its place, the changes of
// a view, and the keeping, removing, renaming and hiding of runs. The values of one gesture, such as the drag
// of a slider, are one edit. Not edits: starting, pausing, stepping, resetting, going on from an iterate and
// the run that this keeps, comparisons of methods (method_comparison.hpp), and the pick of a view, which undo
// leaves as it is. An opening becomes an edit when the solver has accepted it; other changes at once, but
// what the solver refuses leaves no edit.
#pragma once

#include "gui/document/document_run.hpp"
#include "gui/document/edit_history.hpp"
#include "gui/document/method_comparison.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A run that was solved elsewhere and has ended.
struct FinishedRun {
    Scenario scenario;
    std::vector<StepReport> history;
    std::shared_ptr<const Snapshot> snapshot;
};

/// What Document::go_on_from() has done.
struct WentBack {
    std::optional<RunId> kept; ///< the earlier run; empty if it had no reports yet
};

/// One view of one run.
struct DocumentViewport {
    RunId run{};
    Values view; ///< colours, camera, pick: as in a scenario's section `view`
};

/// A shipped scenario as the window opens it: with method and step size `auto` where they are available,
/// instead of the ones that the scenario sets.
Scenario for_window(const Catalogue& catalogue, Scenario scenario);

/// Why it has so many public members: docs/architecture.md.
class Document {
  public:
    /// `notify` is called on a solver thread when there is something to collect; it must be quick.
    /// `before_publishing`: see SolverThread::Options.
    Document(std::shared_ptr<const Catalogue> catalogue, std::function<void()> notify,
             std::function<void(const Snapshot&)> before_publishing = {});
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    /// Adds a run, which starts to solve, and a viewport of it. The first run of a document is active.
    /// `named`: the scenario that name and title belong to, if values were changed before it was opened.
    void open(const Scenario& scenario, const std::optional<Scenario>& named = {});
    /// Adds a run that has ended, and a viewport of it. The run is kept, not live.
    void show(const FinishedRun& finished);

    /// Takes over what the solver threads have produced, every report of it. True if there was anything new.
    bool collect();

    // For live runs:
    /// Continues with other values, from the present map. `dragging`: by a drag that goes on; if these values
    /// are refused, the last valid ones stay.
    void change(RunId run, const Scenario& scenario, bool dragging = false);
    /// Opens another scenario in place of a run's, from its own start, once the solver has accepted it.
    void replace(RunId run, const Scenario& scenario);
    /// Reads the files of a run's values anew, without an edit. If they cannot be read, the mesh stays.
    void reread(RunId run);
    /// Name and title of `saved` are from now on those of its values. A run with the values of a scenario
    /// that was opened or saved has that scenario's name; with other values it has the name given last, and
    /// its scenario lists them as modified.
    void name_saved(RunId run, const Scenario& saved);
    void start(RunId run); ///< a run that has ended starts over
    void pause(RunId run);
    void step(RunId run);  ///< one iteration, then pause
    void reset(RunId run); ///< to the start, paused
    /// Runs from a state, such as that of a file, without an edit. If it does not fit, the mesh stays.
    void start_from(RunId run, std::shared_ptr<const State> state);
    /// Keeps the run as it is, then goes back to a recorded iterate that has its state, at its time, and
    /// pauses there. Not an edit: undo would remove what was solved after that iterate. Empty, and without
    /// effect, while another scenario is opened, since the state is of other values.
    std::optional<WentBack> go_on_from(RunId run, const RecordedIterate& iterate);

    /// Adds a copy of a run as it is now, with a name of its own. Nothing before the first report.
    std::optional<RunId> keep(RunId run);
    /// Removes a kept run that is not active. Viewports that showed it show the active run.
    void remove(RunId run);
    void rename(RunId run, const std::string& name);
    void hide(RunId run, bool hidden);

    /// Solves the problem of the active run with each of these methods.
    void compare(const std::vector<std::string>& methods) { comparison_.begin(methods); }
    void cancel_comparison() { comparison_.cancel(); }
    const MethodComparison& comparison() const { return comparison_; }

    const EditHistory& edits() const { return edits_; }
    /// Take back the last edit, or apply it again. False if there is none.
    bool undo();
    bool redo();
    /// Makes an edit of what was changed in the views since the last call. Changes of the same rows with the
    /// same `gesture` are one edit until end_gesture().
    void record_views(std::string_view gesture = {});
    void end_gesture() { edits_.end_gesture(); }

    DocumentRun& active();
    DocumentRuns& runs() { return runs_; }
    const DocumentRun& active() const;
    const DocumentRuns& runs() const { return runs_; }
    std::vector<DocumentViewport>& viewports() { return viewports_; }
    const std::vector<DocumentViewport>& viewports() const { return viewports_; }

  private:
    friend class MethodComparison;
    DocumentRun make_run(const Scenario& scenario);
    void attach_solver(DocumentRun& run) const;
    void share_memory();
    DocumentRun& add(const Scenario& scenario);
    DocumentRun* add_copy(RunId run);
    DocumentRun& open_for_comparison(const Scenario& scenario, const std::string& method);
    DocumentRun& live(RunId run);
    std::string free_name(const std::string& wish) const;
    std::size_t free_colour() const;
    void discard(RunId run);

    bool collect(DocumentRun& run);
    void take_answer(DocumentRun& run);
    void take_place(DocumentRun& run) const;
    void finish_opening(DocumentRun& run);
    void post_change(DocumentRun& run, const Scenario& scenario, bool same_gesture = false);
    void update_views(const DocumentRun& run);
    void name_values(const Scenario& opened, Scenario& scenario) const;
    void name_values(DocumentRun& run) const;
    void name_opened(const Scenario& opened, const Scenario& named);
    void post_opening(DocumentRun& run, RunOpening opening);

    // in document_edits.cpp
    static RunValues values_of(const DocumentRun& run);
    ViewportState state_of(std::size_t viewport) const;
    std::vector<EditPart> views_of(RunId run) const;
    void record(Edit edit);
    void record_presence(DocumentRun& run, bool before, bool after, std::vector<EditPart> views);
    void take_back_refused(DocumentRun& run);
    void move(bool forward, bool with_values);
    void apply(const std::vector<EditPart>& parts, bool with_values);
    void apply(const RunValues& values, const std::vector<EditPart>& parts);
    void apply(const ViewportState& state);
    void set_others_aside(const DocumentRun& run);
    void apply(const RunPresence& presence);

    std::shared_ptr<const Catalogue> catalogue_;
    std::function<void()> notify_;
    std::function<void(const Snapshot&)> before_publishing_;
    std::vector<DocumentViewport> viewports_;
    std::vector<Values> recorded_; ///< the viewports' views as the last edit left them
    std::uint64_t last_id_ = 0;
    RunId active_ = no_run;
    EditHistory edits_;
    std::vector<bool> moves_; ///< undo (false) and redo (true) that the solver has not answered yet
    /// A scenario with the name of its values, for runs that were opened as `opened`.
    struct NamedValues {
        Scenario opened, named;
    };
    std::vector<NamedValues> named_; ///< in the order in which the names were given
    DocumentRuns runs_;
    std::list<DocumentRun> removed_; ///< that undo or redo can bring back
    MethodComparison comparison_{*this};
};

} // namespace gaspard
