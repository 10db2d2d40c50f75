#include "core/session/solver_thread.hpp"

#include "core/base/error.hpp"

namespace gaspard {

SolverThread::SolverThread(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, Options options)
    : catalogue_(std::move(catalogue)), scenario_(std::move(scenario)), options_(std::move(options)),
      running_(options_.start_running), reports_(options_.report_capacity),
      thread_([this](std::stop_token stop) { work(stop); }) {}

SolverThread::~SolverThread() = default; // the jthread asks to stop and joins

void SolverThread::post(Command command) {
    {
        std::lock_guard lock(mutex_);
        // Of values that follow each other only the last matter: a dragged slider must not queue up work.
        if (std::holds_alternative<ChangeCommand>(command) && !commands_.empty() &&
            std::holds_alternative<ChangeCommand>(commands_.back()))
            commands_.back() = std::move(command);
        else
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

void SolverThread::say(std::string message) {
    update([&](SolverStatus& status) {
        status.message = std::move(message);
        ++status.messages;
    });
}

Progress SolverThread::progress() {
    return [this](double fraction, std::string_view activity) {
        update([&](SolverStatus& status) {
            status.progress = fraction;
            status.activity = std::string(activity);
        });
    };
}

// Waits until there is something to do, unless the run is going.
std::deque<Command> SolverThread::wait_for_commands(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    const bool busy = run_ && run_->status() == RunStatus::running && running_;
    if (!busy) wake_.wait(lock, stop, [&] { return !commands_.empty(); });
    return std::exchange(commands_, {});
}

void SolverThread::work(std::stop_token stop) {
    try {
        prepare(stop);
        while (!stop.stop_requested()) {
            for (auto& command : wait_for_commands(stop)) execute(std::move(command), stop);
            if (stop.stop_requested() || !run_) continue;
            if (running_ && run_->status() == RunStatus::running) run_->step(stop);
            publish(stop);
        }
    } catch (const Interrupted&) {
        return; // asked to stop in the middle of preparing
    } catch (const std::exception& error) {
        const std::string message = error.what();
        update([&](SolverStatus& status) {
            status.run = RunStatus::failed;
            status.activity.clear();
            status.message = message;
            ++status.messages;
        });
    }
}

void SolverThread::prepare(std::stop_token stop) {
    try {
        run_ = std::make_unique<Run>(catalogue_, scenario_, options_.run, progress(), stop);
        publish(stop);
    } catch (const InputError& error) { // there is no run until better values come
        update([&](SolverStatus& status) { status.run = RunStatus::failed, status.activity.clear(); });
        say(error.what());
    }
}

void SolverThread::publish(std::stop_token stop) {
    const bool restarted = epoch_ != run_->epoch();
    if (restarted) epoch_ = run_->epoch(), published_ = 0;
    const auto& history = run_->history();
    const bool news = published_ < history.size();
    if (news) latest_.put(run_->snapshot());
    for (; published_ < history.size(); ++published_)
        if (!reports_.push({published_ == 0, history[published_]}, stop)) return;
    const bool paused = !running_;
    update([&](SolverStatus& status) {
        status.run = run_->status();
        status.paused = paused;
        status.progress = 1;
        status.activity.clear();
    });
}

void SolverThread::execute(Command command, std::stop_token stop) {
    struct Visitor {
        SolverThread& self;
        std::stop_token stop;
        void operator()(StartCommand&) { self.running_ = true; }
        void operator()(PauseCommand&) { self.running_ = false; }
        void operator()(StepCommand&) { // now, so that what is posted after it finds it done
            self.running_ = false;
            const bool possible = self.run_ && self.run_->status() == RunStatus::running;
            if (possible && !stop.stop_requested()) self.run_->step(stop);
        }
        void operator()(ResetCommand&) {
            if (!self.run_) return;
            self.publish(stop); // what the old history has gained
            self.run_->reset();
        }
        void operator()(ChangeCommand& change) {
            if (!stop.stop_requested()) self.change(std::move(change.scenario), stop);
        }
        void operator()(InspectCommand& inspect) { // also when asked to stop: an export is not lost
            if (self.run_)
                inspect.task(*self.run_);
            else
                self.say("There is nothing to save yet.");
        }
    };
    std::visit(Visitor{*this, stop}, command);
}

void SolverThread::change(Scenario scenario, std::stop_token stop) {
    scenario_ = std::move(scenario);
    if (!run_) return prepare(stop);
    try {
        const std::string message = run_->change(scenario_, progress(), stop);
        if (!message.empty()) say(message);
    } catch (const InputError& error) { // the run goes on with its old values
        say(error.what());
    }
}

} // namespace gaspard
