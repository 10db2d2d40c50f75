// A run solves one problem, step by step, on the calling thread.
//
//     Run run(catalogue, scenario);                            // prepares; the start is row 0 of the history
//     while (run.status() == RunStatus::running) run.step();   // or run.solve()
//     const auto mesh = run.snapshot();                        // x, fields, numbers
//
// For a mesh that follows a simulation, call follow() once per time step with the current monitor, then
// solve(); the map of the last time step is the start (examples/follow_a_feature.cpp).
//
// Different runs are independent and may be used on different threads; each run may be used by one thread at
// a time. Snapshots are immutable and may be shared between threads.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "core/session/snapshot.hpp"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

class QualityMeter;

struct RunOptions {
    std::optional<State> start{}; ///< the first iterate; nullopt: the identity map
    int threads = 1;              ///< maximum number of threads; results do not depend on it
};

class Run {
  public:
    /// Prepares the operators and evaluates the start (row 0 of the history). Throws InputError, and
    /// Interrupted if asked to stop.
    Run(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, RunOptions options = {},
        const Progress& progress = {}, std::stop_token stop = {});
    Run(Run&&) noexcept;
    ~Run();

    /// Makes one iteration and returns its report with the new status. Requires status() to be running.
    /// Exceptions of the monitor propagate; the run keeps its last iterate and can continue after follow(),
    /// change() or reset(). Until then, only state() and history() may be called.
    const StepReport& step(std::stop_token stop = {});
    /// Steps until the status is final (interrupted if asked to stop). Returns the last report.
    const StepReport& solve(std::stop_token stop = {});
    /// Computes the diagnostics of the current iterate if they were skipped.
    void complete();
    /// Ends the run with status interrupted and full diagnostics of the current iterate.
    void interrupt();

    /// Continues with other values from the current map, transferred to the new problem; from the last map
    /// without tangled cells if that one has some or the run has diverged; from the identity map if no
    /// transfer is possible. The history continues with a row for the current iterate under the new values. Returns a
    /// message for the user if the map could not be transferred, else an empty string. Throws InputError and
    /// Interrupted before anything has changed.
    std::string change(const Scenario& scenario, const Progress& progress = {}, std::stop_token stop = {});
    /// Replaces the monitor of the scenario by that of the caller; the type of section "monitor" is then
    /// "own". Starts a new history from the current map (from the last one without tangled cells if the run
    /// is tangled or diverged), so that history().back().iteration is the number of iterations for this
    /// monitor. Throws InputError if the monitor is not positive and finite, or if the residual of the map is
    /// not finite for it; then the same holds as after an exception in step().
    void follow(std::shared_ptr<const Monitor> monitor);
    /// Restarts from the identity map, with a new history.
    void reset();

    RunStatus status() const { return history_.back().status; }
    const Scenario& scenario() const { return problem_.scenario; }
    const std::vector<StepReport>& history() const { return history_; }
    /// Number of times that a new history has been started.
    int epoch() const { return epoch_; }
    const State& state() const { return state_; }
    const Discretisation& discretisation() const { return *discretisation_; }
    /// The space of the domain.
    Space space() const { return space_of(*catalogue_, problem_.scenario); }
    double setup_seconds() const { return setup_seconds_; }
    /// The current iterate as a value, with diagnostics even if the history skips them.
    std::shared_ptr<const Snapshot> snapshot();

  private:
    Evaluation first_look(const ProblemData& data, const State& state);
    MonitorContext monitor_context(const Scenario& scenario, const Discretisation& discretisation,
                                   const Progress& progress, std::stop_token stop) const;
    std::unique_ptr<Method> make_method(const Problem& problem,
                                        std::shared_ptr<const Discretisation> discretisation,
                                        const Progress& progress, std::stop_token stop) const;
    void begin(State state, const Evaluation& evaluation);
    void restart_judging();
    void make_meter();
    void find_exact_map();
    void name_series();
    const MethodType& method_type() const;
    void record(const Evaluation& evaluation, int iteration, std::string note);
    void note_folds(StepReport& report) const;
    void take_series(const SeriesValues& values, StepReport& report) const;
    void measure(StepReport& report);
    void add_fields_of_method(Snapshot& snapshot);
    bool out_of_bounds(const StepReport& report) const;
    RunStatus judge(const StepReport& report, std::string& note);
    void take_back(Evaluation& evaluation, std::string& note);

    std::shared_ptr<const Catalogue> catalogue_;
    RunOptions options_;
    Problem problem_;
    std::shared_ptr<const Monitor> own_; ///< the caller's monitor; null: the scenario's
    ProblemData data_;
    std::shared_ptr<const Discretisation> discretisation_;
    std::unique_ptr<Method> method_;
    std::unique_ptr<QualityMeter> meter_;
    std::shared_ptr<const Points> exact_; ///< null if no exact map is known
    State state_, last_finite_;
    State last_untangled_; ///< among the iterates with diagnostics
    std::vector<StepReport> history_;
    std::shared_ptr<const SeriesTable> series_;                 ///< of the reports to come
    std::shared_ptr<const std::vector<std::uint32_t>> tangled_; ///< as in Snapshot, when last measured
    bool measured_ = false; ///< the meter's last measurement is of the present iterate
    bool not_finite_ = false;
    // What the end is judged by; begins anew when values change.
    double first_ = 0, best_ = 0;      ///< values of the criterion (SeriesTable::criterion)
    std::vector<double> first_values_; ///< of the series
    int judged_from_ = 0, best_iteration_ = 0;
    int epoch_ = 0;
    double setup_seconds_ = 0, seconds_ = 0, cpu_seconds_ = 0;
    std::uint64_t version_ = 0;
};

/// Makes the discretisation of a checked problem. Throws InputError, and Interrupted if asked to stop.
std::shared_ptr<const Discretisation> prepare(const Problem& problem, const Progress& progress,
                                              std::stop_token stop);

} // namespace gaspard
