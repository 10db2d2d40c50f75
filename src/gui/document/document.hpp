// What a window shows, as data: runs being solved on threads of their own, and the viewports that look at
// them. A document belongs to the window's thread; only a run's solver thread works elsewhere.
#pragma once

#include "core/session/comparison.hpp"
#include "core/session/solver_thread.hpp"
#include "gui/document/history_curves.hpp"

#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {

/// Where values were changed while a run went on. What follows within half a second of solving, as while a
/// slider is dragged, belongs to the same mark.
struct ChangeMark {
    double iteration = 0, seconds = 0;      ///< where it began
    double last_seconds = 0;                ///< of the last change that belongs to it
    std::shared_ptr<const Scenario> before; ///< the values until then
    std::string text;                       ///< "amplitude 10 to 20"
};

/// What a run's solver says, for whoever shows it.
struct RunMessage {
    std::string text;
    bool error = false;
    bool by_hand = false; ///< of values that the hand tries out as it drags: the next may be right
};

/// One run with all it has told so far: being solved, or kept as it once was.
struct DocumentRun {
    std::uint64_t number = 0; ///< tells it from all others of the document, also from those removed
    std::string title;
    std::string name;  ///< in lists and legends: "Ring, amplitude 20"; of a live run it follows the values
    Scenario opened;   ///< as it was opened: the values that reset buttons restore
    Scenario scenario; ///< as the panels show it; the solver may still be on its way there
    std::vector<StepReport> history; ///< since the run last began anew
    HistoryCurves curves;            ///< the same in columns
    std::vector<ChangeMark> marks;
    std::shared_ptr<const Snapshot> snapshot; ///< the newest; null until the first
    SolverStatus status;
    std::uint64_t asked = 0, answered = 0; ///< numbers of the last change of values: sent, dealt with
    std::uint64_t asked_for_good = 0;      ///< the last of them that was not dragged by hand
    bool wants_to_run = true;              ///< what the user last asked for; the status follows within a step
    /// Another scenario on its way to take this one's place; once it is there, it has been counted.
    struct Opening {
        std::uint64_t number = 0;
        Scenario scenario;
    };
    std::optional<Opening> opening{};
    std::uint64_t openings = 0;
    std::vector<RunMessage> messages{};       ///< not yet taken by whoever shows them
    std::size_t colour = 0;                   ///< which of the theme's curve colours
    bool hidden = false;                      ///< its curves are not shown
    std::shared_ptr<const Scenario> marked{}; ///< the values that the history goes on with
    std::unique_ptr<SolverThread> solver{};   ///< null: kept

    bool live() const { return solver != nullptr; }
    bool ended() const { return is_final(status.run); }
    bool solving() const { return live() && status.run == RunStatus::running && wants_to_run; }
};

/// A run that was solved elsewhere, as it ended.
struct FinishedRun {
    Scenario scenario;
    std::vector<StepReport> history;
    std::shared_ptr<const Snapshot> snapshot;
};

/// One picture of one run.
struct DocumentViewport {
    std::size_t run = 0; ///< which of the document's
    Values view;         ///< colours, camera, what is picked: as in a scenario's view section
};

/// A shipped scenario as the window opens it: its pinned method and step give way to `auto`, which chooses by
/// itself, where that goes with it.
Scenario for_window(const Catalogue& catalogue, Scenario scenario);

/// Iterations per second over the last second of solving; nothing before the first iteration.
std::optional<double> iteration_rate(const std::vector<StepReport>& history);

class Document {
  public:
    /// `notify` is called on a solver thread whenever there is something to collect; it must be quick.
    /// `before_publishing` as in SolverThread::Options.
    Document(std::shared_ptr<const Catalogue> catalogue, std::function<void()> notify,
             std::function<void(const Snapshot&)> before_publishing = {});

    /// Adds a run, which begins to solve at once, and a viewport that looks at it.
    void open(const Scenario& scenario);
    /// Adds a run as it ended, and a viewport that looks at it. It is kept, not live.
    void show(const FinishedRun& finished);

    /// Takes over what the solver threads have produced, every report of it. True if there was anything new.
    bool collect();

    // Of live runs only:
    /// Lets a run go on with other values, from the map it has.
    void change(std::size_t run, const Scenario& scenario);
    /// The same with values of a drag that goes on; what is refused leaves the last good ones.
    void change_by_hand(std::size_t run, const Scenario& scenario);
    /// Another scenario in the place of a run's, from its own start, once it has been found good.
    void replace(std::size_t run, const Scenario& scenario);
    void start(std::size_t run); ///< a run that has ended starts over
    void pause(std::size_t run);
    void step(std::size_t run);  ///< one iteration, then pause
    void reset(std::size_t run); ///< to the start; goes on if it was going, rests if it had ended

    /// Adds a run that stays as this one is now: history, mesh and values, under a name of its own. Returns
    /// its place; nothing before the first report.
    std::optional<std::size_t> keep(std::size_t run);
    /// Removes a kept run. Viewports that looked at it look at the first run.
    void remove(std::size_t run);

    /// Solves the first run's problem with each of these methods, one after the other, each as a run of its
    /// own; the first run waits meanwhile. Takes the place of the comparison before.
    void compare(std::vector<std::string> methods);
    /// The method under way is interrupted; those that wait are forgotten.
    void cancel_comparison();
    bool comparing() const { return comparison_.now != 0; }
    double comparison_progress() const; ///< 0 to 1
    /// Of the methods that have begun, as far as their runs have not been removed.
    std::vector<ComparisonRow> comparison_rows() const;

    std::vector<DocumentRun>& runs() { return runs_; }
    const std::vector<DocumentRun>& runs() const { return runs_; }
    std::vector<DocumentViewport>& viewports() { return viewports_; }
    const std::vector<DocumentViewport>& viewports() const { return viewports_; }

  private:
    struct MethodComparison {
        Scenario scenario;
        std::deque<std::string> waiting;                          ///< methods
        std::vector<std::pair<std::string, std::uint64_t>> begun; ///< methods and the numbers of their runs
        std::size_t total = 0;
        std::uint64_t now = 0; ///< the run under way; 0: none
        bool resume = false;   ///< the first run was solving, and waits for no other reason
    };
    DocumentRun make_run(const Scenario& scenario);
    std::unique_ptr<SolverThread> make_solver(const Scenario& scenario) const;
    DocumentRun& add(const Scenario& scenario);
    DocumentRun* run_numbered(std::uint64_t number);
    void compare_next();
    void collect_comparison();
    void resume_first();
    void leave_waiting(std::size_t run);
    void let_rest(DocumentRun& run);
    bool collect(DocumentRun& run);
    void take_answer(DocumentRun& run);
    void finish_opening(DocumentRun& run);
    std::string free_name(const std::string& wish) const;
    std::size_t free_colour() const;

    std::shared_ptr<const Catalogue> catalogue_;
    std::function<void()> notify_;
    std::function<void(const Snapshot&)> before_publishing_;
    std::vector<DocumentViewport> viewports_;
    std::uint64_t last_number_ = 0;
    MethodComparison comparison_;
    std::vector<DocumentRun> runs_;
    std::vector<std::future<void>> leaving_; ///< solvers of runs let rest, on their way to their end
};

} // namespace gaspard
