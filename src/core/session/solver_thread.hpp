// A run on its own thread. It receives commands, and provides the latest snapshot and all reports.
//
// If values change a little by a gesture that goes on, such as the drag of a slider, while a solved mesh is
// shown, the next snapshot and the next change wait until the mesh has adapted to the new values (residual
// below 1e-2), for at most 0.1 s. All snapshots shown are thus adapted, and only the latest values matter.
// Until 0.25 s after the last change, they have only the diagnostics that are needed (SolverThread::need).
//
// A time step may take long: to pause or reset the run, or to change values that the mesh depends on, ends it
// without effect. Other changes, such as those of the view, are made after it.
#pragma once

#include "core/base/stopwatch.hpp"
#include "core/session/channel.hpp"
#include "core/session/recording.hpp"
#include "core/session/run.hpp"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace gaspard {

struct StartCommand {}; ///< run until the status is final
struct PauseCommand {};
struct StepCommand {};  ///< one iteration, then pause
struct ResetCommand {}; ///< restart from the identity map, paused or running as before
/// Changes values and continues from the current map if possible (Run::change), even if the run had ended.
/// `number` identifies the command in SolverStatus. `anew`: restart from the identity map, with a new
/// history, and run; or from `start`, which must fit to the problem, at its time. `reread`: read files anew
/// (Run::change).
/// `same_gesture`: it goes on with the change before it, as the drag of a slider does. If the values are
/// invalid or the command is cancelled, the run does not change.
struct ChangeCommand {
    Scenario scenario;
    std::uint64_t number = 0;
    bool anew = false;
    bool paused = false; ///< do not run after that
    bool reread = false;
    bool same_gesture = false;
    std::shared_ptr<const State> start{};
    std::optional<double> time{}; ///< of `start`; nullopt: the scenario has no time
};
/// Arguments of long work: a callback for its progress, and a stop token.
struct Activity {
    Progress progress;
    std::stop_token stop;
};
/// Executes a task between two steps on the solver thread, which owns the run: exports, tests. A cancelled
/// task may throw Interrupted; other exceptions become error messages.
struct InspectCommand {
    std::function<void(Run&, const Activity&)> task;
};
using Command =
    std::variant<StartCommand, PauseCommand, StepCommand, ResetCommand, ChangeCommand, InspectCommand>;

/// What a report is to the history before it.
enum class SolverEventKind {
    step,         ///< its next row
    completion,   ///< its last row again, with what has been measured since
    restart,      ///< row 0 of a new history, which starts from the identity map
    change,       ///< row 0 of a new history, which starts from the present map under other values
    same_gesture, ///< the same within the gesture of the last change
};

/// One entry of the lossless queue.
struct SolverEvent {
    SolverEventKind kind = SolverEventKind::step;
    StepReport report;
};

/// A message for the user.
struct SolverMessage {
    std::string text;
    bool error = false; ///< an error, not an informational message
};

/// The state of the thread, for a status line.
struct SolverStatus {
    RunStatus run = RunStatus::preparing;
    bool paused = true;
    double progress = 0;                      ///< progress of the preparation, in [0, 1]
    std::string activity;                     ///< current step of the preparation
    std::uint64_t messages = 0;               ///< total number of messages
    std::uint64_t answered = 0;               ///< number of the last ChangeCommand that was executed
    bool refused = false;                     ///< whether that command failed: invalid values, or cancelled
    std::shared_ptr<const Scenario> scenario; ///< current values of the run; null before the first run
};

struct SolverNews {
    SolverStatus status;
    std::vector<SolverMessage> messages;
};

class SolverThread {
  public:
    struct Options {
        bool start_running = true;
        RunOptions run{};
        std::size_t report_capacity = 4096; ///< the run waits if so many reports are not fetched
        std::function<void()> notify{};     ///< called on the solver thread after each change; must be fast
        /// Called on the solver thread before a snapshot is published, for expensive preparation of its
        /// display.
        std::function<void(const Snapshot&)> before_publishing{};
        /// The share of the time that interpolation errors may take while the run is running; those of a
        /// final mesh are always measured, but not while a gesture goes on. 0: none are measured.
        double interpolation_share = 0;
        /// Gets every iterate of the present history; null: nothing is recorded.
        std::shared_ptr<Recording> recording{};
        int nicer = 0; ///< lower_priority() of the thread: what shows the run goes first
        /// The thread rests for so many seconds after the first snapshot for values that a gesture has
        /// changed, while it is drawn, or until there is a command.
        double rest_for_drawing = 0;
    };

    SolverThread(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, Options options);
    /// Stops within one step, or during preparation at the next check of the stop token.
    ~SolverThread();
    SolverThread(const SolverThread&) = delete;
    SolverThread& operator=(const SolverThread&) = delete;

    void post(Command command);
    /// Cancels the current preparation or task, if any; the run does not change.
    void cancel();
    /// Diagnostics that snapshots must have while values change; full unless set.
    void need(Diagnostics level) { needed_ = level; }
    /// The latest snapshot; null before the first.
    std::shared_ptr<const Snapshot> latest() const { return latest_.get(); }
    /// All reports since the last call, in order.
    std::vector<SolverEvent> drain() { return reports_.drain(); }
    /// The status and all messages since the last call, in order, of one moment: what is said about a change
    /// of values comes together with the answer to it.
    SolverNews take_news();
    SolverStatus status() const;

  private:
    void work(std::stop_token stop);
    bool prepare(std::stop_token stop);
    bool cancellable(std::stop_token stop, const std::function<void(const Activity&)>& work);
    void execute(Command command, std::stop_token stop);
    void start(std::stop_token stop);
    void inspect(const InspectCommand& command);
    void change(ChangeCommand command, std::stop_token stop);
    void begin_anew(const ChangeCommand& command, std::stop_token stop);
    void answer(std::uint64_t number, bool refused);
    void publish(std::stop_token stop);
    void measure_interpolation(std::stop_token stop);
    bool send_reports(std::stop_token stop);
    void say(std::string message, bool error = false);
    void attempt(const std::function<void()>& work);
    void fail(const std::string& message);
    void update(const std::function<void(SolverStatus&)>& change);
    Progress progress();
    bool behind() const;
    bool dragged() const;
    void begin_to_follow(bool was_solved);
    void record(const Snapshot& snapshot);
    void record_hidden();
    void step(std::stop_token stop);
    void make_step(std::stop_token stop, int time_steps = 1);
    bool ends_time_step(const Command& command) const;
    std::deque<Command> take_commands();
    std::deque<Command> wait_for_commands(std::stop_token stop);

    std::shared_ptr<const Catalogue> catalogue_;
    Scenario scenario_;
    Options options_;
    std::unique_ptr<Run> run_;   ///< used only by the solver thread
    int sent_ = -1;              ///< iteration of the last row of the history in the queue; -1: none
    long measured_ = 0;          ///< how much of it was measured when it was sent
    int epoch_ = 0;              ///< epoch of that history
    int recorded_epoch_ = 0;     ///< epoch of the history that is recorded
    bool gesture_begun_ = false; ///< the present history began with a change of the last gesture
    SolverEventKind begins_ = SolverEventKind::restart; ///< how the present history began
    bool shown_ = false;        ///< the current iterate has been published as snapshot
    bool partly_shown_ = false; ///< with fewer diagnostics than the run has
    bool small_change_ = false; ///< the last change of values was small
    std::atomic<Diagnostics> needed_ = Diagnostics::full;
    bool lets_draw_ = false; ///< the next thing to do is to rest
    bool following_ = false; ///< values have changed a little since the last snapshot
    Stopwatch since_change_; ///< time since that change
    Stopwatch since_errors_; ///< time since interpolation errors were last measured
    double errors_rest_ = 0; ///< seconds for which they are not measured again
    bool running_ = false;
    std::optional<Stopwatch> pace_{}; ///< of time.speed; empty: time has not begun to pass
    double pace_from_ = 0;            ///< the time then
    bool changing_ = false;           ///< a change of values is being executed
    std::vector<SolverMessage> held_; ///< messages about it, until it is answered

    Latest<Snapshot> latest_;
    Channel<SolverEvent> reports_;
    mutable std::mutex mutex_; ///< protects commands_, messages_, status_, activity_ and in_time_step_
    std::condition_variable_any wake_;
    std::deque<Command> commands_;
    std::vector<SolverMessage> messages_;
    SolverStatus status_;
    std::optional<std::stop_source> activity_; ///< stop source of the work that cancel() ends
    bool in_time_step_ = false;                ///< that work is a time step, which some commands end
    std::jthread thread_;                      ///< last, so that it is joined before the members it uses go
};

} // namespace gaspard
