// A run on a thread of its own: commands in; out come the newest snapshot and every report.
//
// Values that change a little while a solved mesh is shown, as when the hand drags the monitor, are followed:
// the next snapshot, and the next values, wait until the mesh has caught up with these ones (a residual below
// 1e-2), a tenth of a second at most. So what is seen is adapted, and the last values win.
#pragma once

#include "core/base/stopwatch.hpp"
#include "core/session/channel.hpp"
#include "core/session/run.hpp"

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
struct ResetCommand {}; ///< back to the identity map, paused or running as before
/// Other values, from the present map where possible; a run that had ended goes on. `number` tells one such
/// command from another in SolverStatus. `anew`: from the identity map, with a new history, and running.
/// Values that are refused, or cancelled, leave the run as it was.
struct ChangeCommand {
    Scenario scenario;
    std::uint64_t number = 0;
    bool anew = false;
};
/// What long work is given: where to say how far it is, and when to give up.
struct Activity {
    Progress progress;
    std::stop_token stop;
};
/// Done between two steps on the solver thread, which owns the run: exports, tests. A task that is cancelled
/// may throw Interrupted; what else it throws is said as an error.
struct InspectCommand {
    std::function<void(Run&, const Activity&)> task;
};
using Command =
    std::variant<StartCommand, PauseCommand, StepCommand, ResetCommand, ChangeCommand, InspectCommand>;

/// One entry of the lossless queue. `restarted`: this is row 0 of a new history, the plot begins anew.
struct SolverEvent {
    bool restarted = false;
    StepReport report;
};

/// A sentence for the user.
struct SolverMessage {
    std::string text;
    bool error = false; ///< something did not work, as against a remark
};

/// How the thread stands, for a status line.
struct SolverStatus {
    RunStatus run = RunStatus::preparing;
    bool paused = true;
    double progress = 0;        ///< of the preparation, 0 to 1
    std::string activity;       ///< what is being prepared
    std::uint64_t messages = 0; ///< how many sentences so far
    std::uint64_t answered = 0; ///< the number of the last ChangeCommand that was dealt with ...
    bool refused = false; ///< ... and whether it changed nothing: its values were wrong, or it was cancelled
    std::shared_ptr<const Scenario>
        scenario; ///< the values that the run works with; null before there is one
};

class SolverThread {
  public:
    struct Options {
        bool start_running = true;
        RunOptions run{};
        std::size_t report_capacity = 4096; ///< the run waits when nobody takes its reports
        std::function<void()> notify{};     ///< called on the solver thread after anything new; must be quick
        /// Called on the solver thread before a snapshot is published: what would take those long who show it
        /// can be made here.
        std::function<void(const Snapshot&)> before_publishing{};
    };

    SolverThread(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, Options options);
    /// Stops within one step (or within the preparation, at its next look at the stop token).
    ~SolverThread();
    SolverThread(const SolverThread&) = delete;
    SolverThread& operator=(const SolverThread&) = delete;

    void post(Command command);
    /// Ends the preparation or the task under way, if there is any; the run stays as it was before.
    void cancel();
    /// The newest snapshot; null until the first.
    std::shared_ptr<const Snapshot> latest() const { return latest_.get(); }
    /// Every report since the last call, in order, none left out.
    std::vector<SolverEvent> drain() { return reports_.drain(); }
    /// Every sentence since the last call, in order.
    std::vector<SolverMessage> take_messages();
    SolverStatus status() const;

  private:
    void work(std::stop_token stop);
    bool prepare(std::stop_token stop);
    bool cancellable(std::stop_token stop, const std::function<void(const Activity&)>& work);
    void execute(Command command, std::stop_token stop);
    void start(std::stop_token stop);
    void inspect(const InspectCommand& command);
    void change(ChangeCommand command, std::stop_token stop);
    void begin_anew(std::stop_token stop);
    void answer(std::uint64_t number, bool refused);
    void publish(std::stop_token stop);
    void say(std::string message, bool error = false);
    void attempt(const std::function<void()>& work);
    void fail(const std::string& message);
    void update(const std::function<void(SolverStatus&)>& change);
    Progress progress();
    bool behind() const;
    void begin_to_follow(bool was_solved);
    std::deque<Command> take_commands();
    std::deque<Command> wait_for_commands(std::stop_token stop);

    std::shared_ptr<const Catalogue> catalogue_;
    Scenario scenario_;
    Options options_;
    std::unique_ptr<Run> run_;  ///< touched by the solver thread only
    std::size_t published_ = 0; ///< rows of the run's history already in the queue
    int epoch_ = 0;             ///< of the history they belong to
    bool shown_ = false;        ///< the newest iterate is the newest snapshot
    bool following_ = false;    ///< values have moved a little since the last snapshot ...
    Stopwatch since_change_;    ///< ... so long ago
    bool running_ = false;

    Latest<Snapshot> latest_;
    Channel<SolverEvent> reports_;
    mutable std::mutex mutex_; ///< commands_, messages_, status_ and activity_
    std::condition_variable_any wake_;
    std::deque<Command> commands_;
    std::vector<SolverMessage> messages_;
    SolverStatus status_;
    std::optional<std::stop_source> activity_; ///< of what cancel() would end
    std::jthread thread_;                      ///< last, so that it ends before what it uses
};

} // namespace gaspard
