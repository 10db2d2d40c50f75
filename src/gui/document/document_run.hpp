// A run of a document: its values, its history and, while it is live, the solver that works on it.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "core/session/recording.hpp"
#include "core/session/solver_thread.hpp"
#include "gui/document/history_curves.hpp"

#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// Identifies a run within its document. An id is never used again, not even after its run was removed.
enum class RunId : std::uint64_t {};
constexpr RunId no_run{};

/// The curves of a solve with other values, before the present one. The solves within one gesture, such as
/// the drag of a slider, count as the last of them.
struct EarlierSolve {
    HistoryCurves curves;
    std::string name; ///< its values where the next ones differ: "Amplitude A = 10"
};

/// A message of a run's solver.
struct RunMessage {
    std::string text;
    bool error = false;
    bool dragging = false; ///< about values of a drag that goes on; the next ones may be valid
};

/// Numbers of the changes of values that were sent to the solver, and of those that it has answered.
struct RunChanges {
    std::uint64_t asked = 0, answered = 0;
    std::uint64_t asked_for_good = 0; ///< the last change that did not belong to a drag that goes on

    /// The solver works with what the document shows.
    bool settled() const { return answered == asked; }
    /// All changes without an answer belong to a drag that goes on.
    bool only_dragging() const { return answered < asked && asked_for_good <= answered; }
};

/// Where a viewport stands in an edit; see DocumentViewport.
struct ViewportState {
    std::size_t viewport = 0; ///< its index
    RunId run{};
    Values view; ///< without the pick
    friend bool operator==(const ViewportState&, const ViewportState&) = default;
};

/// A scenario on its way to replace the one of a run. It takes effect when the solver has accepted it.
struct RunOpening {
    std::uint64_t number = 0; ///< of the change that asks for it
    Scenario opened, scenario;
    std::vector<ViewportState> viewports{}; ///< to restore with it; empty: the view of the scenario
    bool from_history = false;              ///< asked for by undo or redo
};

struct DocumentRun {
    RunId id{};
    std::string title; ///< of the scenario, as scenario_title()
    std::string
        name; ///< in lists and legends: "Ring, amplitude 20"; the name of a live run follows its values
    Scenario opened;                  ///< as it was opened: the values that reset buttons restore
    Scenario scenario;                ///< as the panels show it; the solver may not have these values yet
    std::vector<StepReport> history;  ///< since the values were last changed or the run was reset; bounded as
                                      ///< Run::history()
    HistoryCurves curves;             ///< the same in columns
    std::deque<EarlierSolve> earlier; ///< since the run was last reset; oldest first, at most most_earlier
    std::uint64_t histories = 0;      ///< how many have begun
    std::shared_ptr<Recording> recording{};   ///< the iterates of the history; null: not recorded
    std::shared_ptr<const Snapshot> snapshot; ///< the newest; null before the first
    SolverStatus status;
    RunChanges changes;
    bool wants_to_run = true; ///< what the user last asked for; the status follows within a step
    std::optional<RunOpening> opening{};
    std::uint64_t openings = 0;         ///< how many scenarios have replaced the first one
    std::vector<RunMessage> messages{}; ///< not yet taken by the panels
    std::size_t colour = 0;             ///< index of the theme's curve colour
    bool hidden = false;                ///< its curves are not shown
    bool set_aside = false; ///< hidden because another problem was opened; shown again with its own
    std::shared_ptr<const Scenario> solved{}; ///< the values of the history's last row
    std::unique_ptr<SolverThread> solver{};   ///< null: the run is kept, not live

    bool live() const { return solver != nullptr; }
    bool ended() const { return is_final(status.run); }
    bool solving() const { return live() && status.run == RunStatus::running && wants_to_run; }
};

/// The runs of a document in their order. A reference to a run stays valid until the run is removed, however
/// many others are added or removed; a run that is taken out and put back keeps its address.
class DocumentRuns {
  public:
    auto begin() { return runs_.begin(); }
    auto end() { return runs_.end(); }
    auto begin() const { return runs_.begin(); }
    auto end() const { return runs_.end(); }
    std::size_t size() const { return runs_.size(); }
    bool empty() const { return runs_.empty(); }
    DocumentRun& operator[](std::size_t place) { return *at(place); }
    const DocumentRun& operator[](std::size_t place) const;

    DocumentRun& push_back(DocumentRun run);
    /// Null if there is no such run.
    DocumentRun* find(RunId id);
    const DocumentRun* find(RunId id) const;
    std::size_t place_of(RunId id) const;
    /// Removes a run; the list returned owns it.
    std::list<DocumentRun> take(RunId id);
    /// Inserts a run that was taken out; at the end if there are fewer than `place` runs.
    DocumentRun& put_back(std::size_t place, std::list<DocumentRun> run);

  private:
    std::list<DocumentRun>::iterator at(std::size_t place);

    std::list<DocumentRun> runs_;
};

/// All recordings of a document together may have so many bytes.
constexpr std::size_t recording_memory = std::size_t{512} << 20U;
/// They have so many.
std::size_t recorded_bytes(const DocumentRuns& runs);

constexpr std::size_t most_earlier = 8;

/// Whether two runs can be compared: domain and monitor, and what else says what is solved, are of one kind,
/// whatever their numbers.
bool alike(const Scenario& a, const Scenario& b);

/// Appends a report to the history. If it is the first with other values, the history before it becomes an
/// earlier solve.
void append(DocumentRun& run, const Catalogue& catalogue, const SolverEvent& event);

/// Iterations per second over the last second of solving; nothing before the first iteration.
std::optional<double> iteration_rate(const std::vector<StepReport>& history);

} // namespace gaspard
