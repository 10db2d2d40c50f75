#include "core/session/solver_thread.hpp"

#include "core/base/error.hpp"
#include "core/base/this_thread.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr double caught_up = 1e-2;   // residual below which a mesh has adapted to its values
constexpr double near = 0.3;         // residual below which a change of values is small
constexpr double longest_wait = 0.1; // seconds
constexpr double rest = 0.25;        // seconds after the last small change at which a drag is over

} // namespace

/// Whether the run is not to complete a time step before this is done. A change that leaves the mesh as it
/// is, such as one of the view alone, waits for it. Called with the mutex.
bool SolverThread::ends_time_step(const Command& command) const {
    const auto* change = std::get_if<ChangeCommand>(&command);
    if (!change)
        return std::holds_alternative<PauseCommand>(command) || std::holds_alternative<ResetCommand>(command);
    const auto& now = status_.scenario;
    return change->anew || change->reread || !now || !same_problem_data(change->scenario, *now) ||
           change->scenario.method != now->method;
}

SolverThread::SolverThread(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, Options options)
    : catalogue_(std::move(catalogue)), scenario_(std::move(scenario)), options_(std::move(options)),
      running_(options_.start_running), reports_(options_.report_capacity),
      thread_([this](std::stop_token stop) { work(stop); }) {}

SolverThread::~SolverThread() = default; // the jthread requests a stop and joins

void SolverThread::post(Command command) {
    {
        std::lock_guard lock(mutex_);
        if (in_time_step_ && ends_time_step(command)) activity_->request_stop();
        // Consecutive changes are merged, so that dragging a slider does not queue up work.
        auto* change = std::get_if<ChangeCommand>(&command);
        const auto* before = commands_.empty() ? nullptr : std::get_if<ChangeCommand>(&commands_.back());
        if (change && before) {
            change->reread = change->reread || before->reread;
            change->same_gesture = change->same_gesture && before->same_gesture;
            if (before->start && !change->anew) { // the later values, from the same start
                change->anew = true, change->paused = before->paused;
                change->start = before->start, change->time = before->time;
            }
            commands_.back() = std::move(command);
        } else
            commands_.push_back(std::move(command));
    }
    wake_.notify_one();
}

SolverStatus SolverThread::status() const {
    std::lock_guard lock(mutex_);
    return status_;
}

void SolverThread::update(const std::function<void(SolverStatus&)>& change) {
    {
        std::lock_guard lock(mutex_);
        change(status_);
    }
    if (options_.notify) options_.notify();
}

void SolverThread::say(std::string message, bool error) {
    if (changing_) return held_.push_back({std::move(message), error});
    update([&](SolverStatus& status) {
        messages_.push_back({std::move(message), error});
        ++status.messages;
    });
}

SolverNews SolverThread::take_news() {
    std::lock_guard lock(mutex_);
    return {status_, std::exchange(messages_, {})};
}

Progress SolverThread::progress() {
    return [this](double fraction, std::string_view activity) {
        update([&](SolverStatus& status) {
            status.progress = fraction;
            status.activity = std::string(activity);
        });
    };
}

// Takes the commands; waits for one unless the run is running.
std::deque<Command> SolverThread::wait_for_commands(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    const bool busy = run_ && run_->status() == RunStatus::running && running_;
    const auto* change = commands_.empty() ? nullptr : std::get_if<ChangeCommand>(&commands_.front());
    if (change && !change->anew && behind()) return {};
    const auto commanded = [&] { return !commands_.empty(); };
    if (!busy) wake_.wait(lock, stop, commanded);
    const std::chrono::duration<double> pause(options_.rest_for_drawing);
    if (std::exchange(lets_draw_, false) && busy) wake_.wait_for(lock, stop, pause, commanded);
    return std::exchange(commands_, {});
}

/// Whether the mesh has not yet adapted to values that were changed a little.
bool SolverThread::behind() const {
    if (!following_ || !running_ || !run_ || run_->status() != RunStatus::running) return false;
    return run_->history().back().residual >= caught_up && since_change_.seconds() < longest_wait;
}

/// Whether values are being changed by small amounts; further snapshots follow.
bool SolverThread::dragged() const {
    return small_change_ && running_ && run_->status() == RunStatus::running &&
           since_change_.seconds() < rest;
}

void SolverThread::begin_to_follow(bool was_solved) {
    following_ = small_change_ = was_solved && run_->history().back().residual < near;
    since_change_ = {};
}

void SolverThread::cancel() {
    std::lock_guard lock(mutex_);
    if (activity_) activity_->request_stop();
}

/// Does work that cancel() and `stop` can interrupt. Returns false if it was cancelled; throws Interrupted if
/// the whole thread is to stop.
bool SolverThread::cancellable(std::stop_token stop, const std::function<void(const Activity&)>& work) {
    const std::stop_source source;
    const auto set_activity = [&](std::optional<std::stop_source> activity) {
        std::lock_guard lock(mutex_);
        activity_ = std::move(activity);
        in_time_step_ = false;
    };
    set_activity(source);
    const std::stop_callback link(stop, [source]() mutable { source.request_stop(); });
    bool finished = true;
    try {
        work({progress(), source.get_token()});
    } catch (const Interrupted&) {
        finished = false;
    } catch (...) {
        set_activity(std::nullopt);
        throw;
    }
    set_activity(std::nullopt);
    if (!finished && stop.stop_requested()) throw Interrupted();
    return finished;
}

std::deque<Command> SolverThread::take_commands() {
    std::lock_guard lock(mutex_);
    return std::exchange(commands_, {});
}

/// Ends the run with an error; there is none until values change or it is started again.
void SolverThread::fail(const std::string& message) {
    run_.reset();
    running_ = false;
    sent_ = -1, epoch_ = recorded_epoch_ = -1; // the next run has another history
    begins_ = SolverEventKind::restart;
    shown_ = partly_shown_ = following_ = small_change_ = false;
    update([](SolverStatus& status) { status.run = RunStatus::failed, status.activity.clear(); });
    say(message, true);
}

/// Internal and system errors end the run, but not the thread, which continues to execute commands.
void SolverThread::attempt(const std::function<void()>& work) {
    try {
        work();
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

void SolverThread::work(std::stop_token stop) {
    name_thread("solver");
    lower_priority(options_.nicer);
    try {
        attempt([&] { prepare(stop); });
        while (!stop.stop_requested()) {
            for (auto& command : wait_for_commands(stop)) attempt([&] { execute(std::move(command), stop); });
            if (stop.stop_requested() || !run_) continue;
            attempt([&] {
                if (running_ && run_->status() == RunStatus::running) step(stop);
                publish(stop);
            });
        }
    } catch (const Interrupted&) { // asked to stop during preparation
    }
    for (auto& command : take_commands()) // requested exports are still done
        if (const auto* task = std::get_if<InspectCommand>(&command); task && run_) inspect(*task);
}

/// One iteration, or the time steps that are due with time.speed; waits for a command while none is.
void SolverThread::step(std::stop_token stop) {
    const Values& time = run_->scenario().time;
    const double speed = run_->moves() ? time.real("speed") : 0;
    if (!(speed > 0)) {
        pace_.reset();
        make_step(stop);
        return;
    }
    if (!pace_ || epoch_ != run_->epoch()) pace_.emplace(), pace_from_ = *run_->time();
    const double ahead = pace_from_ + speed * pace_->seconds() - *run_->time(), dt = time.real("step");
    const double due = std::min(std::floor(ahead / dt), 1e6);
    if (due >= 1) {
        make_step(stop, static_cast<int>(due));
        return;
    }
    std::unique_lock lock(mutex_);
    const std::chrono::duration<double> rest(std::min((dt - ahead) / speed, 0.1));
    wake_.wait_for(lock, stop, rest, [&] { return !commands_.empty(); });
}

/// One iteration, or so many time steps at once, unless a command ends them.
void SolverThread::make_step(std::stop_token stop, int time_steps) {
    if (!run_->moves()) {
        run_->step(stop);
        return;
    }
    cancellable(stop, [&](const Activity& activity) {
        {
            std::lock_guard lock(mutex_);
            const auto ends = [this](const Command& command) { return ends_time_step(command); };
            if (!behind() && std::ranges::any_of(commands_, ends)) return;
            in_time_step_ = true;
        }
        run_->step(activity.stop, time_steps);
    });
}

/// Makes the run. Returns false if that fails or is cancelled.
bool SolverThread::prepare(std::stop_token stop) {
    const auto give_up = [this](RunStatus status, const std::string& message, bool error) {
        update([&](SolverStatus& now) { now.run = status, now.activity.clear(); });
        say(message, error);
        return false;
    };
    update([](SolverStatus& status) { status.run = RunStatus::preparing; });
    try {
        const bool finished = cancellable(stop, [this](const Activity& activity) {
            run_ =
                std::make_unique<Run>(catalogue_, scenario_, options_.run, activity.progress, activity.stop);
        });
        if (!finished)
            return give_up(RunStatus::interrupted,
                           "The preparation was cancelled; press Run to start it again.", false);
    } catch (const InputError& error) {
        return give_up(RunStatus::failed, error.what(), true);
    }
    update([this](SolverStatus& status) {
        status.scenario = std::make_shared<const Scenario>(run_->scenario());
    });
    publish(stop);
    return true;
}

void SolverThread::publish(std::stop_token stop) {
    const bool news = epoch_ != run_->epoch() || sent_ < run_->history().back().iteration;
    const bool to_be_completed = partly_shown_ && !dragged();
    shown_ = shown_ && !news && !to_be_completed;
    if (!shown_ && !behind()) {
        shown_ = true;
        lets_draw_ = std::exchange(following_, false) && options_.rest_for_drawing > 0;
        partly_shown_ = dragged() && needed_ != Diagnostics::full;
        measure_interpolation(stop);
        auto snapshot = run_->snapshot(partly_shown_ ? needed_.load() : Diagnostics::full);
        if (options_.before_publishing) options_.before_publishing(*snapshot);
        record(*snapshot);
        latest_.put(std::move(snapshot));
    } else if (!shown_) {
        record_hidden();
    }
    if (!send_reports(stop)) return;
    const bool paused = !running_;
    update([&](SolverStatus& status) {
        status.run = run_->status();
        status.paused = paused;
        status.progress = 1;
        status.activity.clear();
    });
}

/// An iterate that is not shown, but may be looked at again.
void SolverThread::record_hidden() {
    if (options_.recording) record(*run_->snapshot(needed_));
}

void SolverThread::record(const Snapshot& snapshot) {
    if (!options_.recording) return;
    if (recorded_epoch_ != run_->epoch()) options_.recording->begin();
    recorded_epoch_ = run_->epoch();
    Recording& recording = *options_.recording;
    const bool with_state = recording.wants_state(snapshot.report.iteration);
    recording.add(snapshot, with_state ? std::make_shared<const State>(run_->state()) : nullptr);
}

/// Before a snapshot, if that is due. The errors of a mesh that changes soon are measured less precisely.
void SolverThread::measure_interpolation(std::stop_token stop) {
    if (!(options_.interpolation_share > 0)) return;
    if (dragged()) return; // the hand is followed first
    const bool running = running_ && run_->status() == RunStatus::running;
    if (running && run_->history().size() == 1) return; // the first picture does not wait for them
    if (running && since_errors_.seconds() < errors_rest_) return;
    const Stopwatch watch;
    try {
        run_->interpolation({.tolerance = 1e-2, .halvings = 4, .parts = 30, .stop = stop});
    } catch (const InputError& error) { // the function has no value somewhere
        say(error.what(), true);
        errors_rest_ = std::numeric_limits<double>::infinity();
        return;
    } catch (const Interrupted&) { // the thread ends
        return;
    }
    errors_rest_ = watch.seconds() * (1 / options_.interpolation_share - 1);
    since_errors_ = {};
}

/// How much of a report has been measured.
static long measured(const StepReport& report) {
    const auto values = std::count_if(report.values.begin(), report.values.end(),
                                      [](double value) { return !std::isnan(value); });
    return values + (report.tangled_cells ? 1 : 0);
}

/// The new ones, and the last one sent if more of it has been measured. Returns false if asked to stop.
bool SolverThread::send_reports(std::stop_token stop) {
    const auto& history = run_->history();
    if (epoch_ != run_->epoch()) epoch_ = run_->epoch(), sent_ = -1;
    auto next = std::ranges::upper_bound(history, sent_, {}, &StepReport::iteration);
    if (next != history.begin())
        if (const StepReport& last = *std::prev(next); last.iteration == sent_ && measured(last) > measured_)
            if (!reports_.push({SolverEventKind::completion, last}, stop)) return false;
    for (; next != history.end(); ++next) {
        const SolverEventKind kind = sent_ < 0 ? begins_ : SolverEventKind::step;
        if (!reports_.push({kind, *next}, stop)) return false;
        sent_ = next->iteration;
    }
    measured_ = measured(history.back());
    return true;
}

void SolverThread::execute(Command command, std::stop_token stop) {
    struct Visitor {
        SolverThread& self;
        std::stop_token stop;
        void operator()(StartCommand&) { self.start(stop); }
        void operator()(PauseCommand&) { self.running_ = false, self.pace_.reset(); }
        void operator()(StepCommand&) { // immediately, so that later commands see the result
            self.running_ = false, self.pace_.reset();
            const bool possible = self.run_ && self.run_->status() == RunStatus::running;
            if (possible && !stop.stop_requested()) self.make_step(stop);
        }
        void operator()(ResetCommand&) {
            if (!self.run_) return;
            self.following_ = false;
            self.publish(stop); // the rest of the old history
            self.pace_.reset();
            self.run_->reset();
            self.record_hidden(); // a start that follows at once leaves no time to publish it
            self.begins_ = SolverEventKind::restart;
            self.update([](SolverStatus& status) { status.run = RunStatus::running; });
        }
        void operator()(ChangeCommand& change) {
            if (!stop.stop_requested()) self.change(std::move(change), stop);
        }
        void operator()(InspectCommand& inspect) { // also if asked to stop, so that no export is lost
            self.inspect(inspect);
        }
    };
    std::visit(Visitor{*this, stop}, command);
}

void SolverThread::start(std::stop_token stop) {
    running_ = true;
    pace_.reset();
    if (!run_) prepare(stop);
}

void SolverThread::inspect(const InspectCommand& command) {
    if (!run_) return say("There is nothing to save yet.", true);
    bool finished = true;
    try {
        finished = cancellable({}, [&](const Activity& activity) { command.task(*run_, activity); });
    } catch (const std::exception& error) {
        say(error.what(), true);
    }
    update([](SolverStatus& status) { status.activity.clear(); });
    if (!finished) say("Cancelled.");
}

void SolverThread::change(ChangeCommand command, std::stop_token stop) {
    pace_.reset();
    bool refused = false;
    if (!command.same_gesture) gesture_begun_ = false;
    if (run_ && !send_reports(stop)) return; // the rest of the old history
    changing_ = true;
    try {
        if (!run_) {
            scenario_ = command.scenario;
            running_ = running_ || command.anew;
            refused = !prepare(stop);
        } else {
            const bool solved = run_->history().back().residual < caught_up &&
                                run_->scenario().domain == command.scenario.domain;
            refused = !cancellable(stop, [&](const Activity& activity) {
                const std::string message =
                    run_->change(command.scenario, activity.progress, activity.stop,
                                 solved ? needed_.load() : Diagnostics::full, command.reread);
                if (!message.empty() && !command.anew) say(message); // a restart keeps no map anyway
            });
            if (refused)
                say("Cancelled; the values were not changed.");
            else {
                begin_to_follow(solved && command.same_gesture);
                if (epoch_ != run_->epoch())
                    begins_ = std::exchange(gesture_begun_, true) ? SolverEventKind::same_gesture
                                                                  : SolverEventKind::change;
            }
        }
        if (!refused && command.anew) begin_anew(command, stop);
    } catch (const InputError& error) { // the run keeps its old values
        refused = true;
        say(error.what(), true);
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception& error) { // the state of the run is undefined
        refused = true;
        fail(error.what());
    }
    if (!refused) scenario_ = std::move(command.scenario);
    answer(command.number, refused);
    if (!run_ || refused) return;
    if (!following_)
        publish(stop); // before the next step
    else
        record_hidden();
}

void SolverThread::begin_anew(const ChangeCommand& command, std::stop_token stop) {
    following_ = false;
    publish(stop); // the rest of the old history
    if (!command.start)
        run_->reset();
    else if (command.time)
        run_->go_on_from(*command.start, *command.time, stop);
    else
        run_->start_from(*command.start, stop);
    begins_ = SolverEventKind::restart;
    running_ = !command.paused;
}

void SolverThread::answer(std::uint64_t number, bool refused) {
    auto scenario = run_ ? std::make_shared<const Scenario>(run_->scenario()) : nullptr;
    changing_ = false;
    update([&](SolverStatus& status) {
        status.messages += held_.size();
        messages_.insert(messages_.end(), held_.begin(), held_.end());
        status.answered = number;
        status.refused = refused;
        if (scenario) {
            status.scenario = std::move(scenario);
            if (!refused) status.run = RunStatus::running; // ended only once its reports have been sent
        }
        status.activity.clear();
    });
    held_.clear();
}

} // namespace gaspard
