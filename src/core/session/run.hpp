// One problem being solved, one call at a time, on whatever thread calls.
//
//     Run run(catalogue, scenario);                            // prepares; the start is row 0 of the history
//     while (run.status() == RunStatus::running) run.step();   // or run.solve()
//     const auto mesh = run.snapshot();                        // x, fields, numbers
//
// A mesh that follows a simulation: follow() once per time step with the monitor of the moment, then solve();
// the map of the last time step is the start (examples/follow_a_feature.cpp).
//
// Different runs are independent of each other and may be used on different threads; a single one by one
// thread at a time. Snapshots are immutable and may go anywhere.
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
    std::optional<State> start{}; ///< the first iterate; empty: the identity map
    int threads = 1;              ///< how many this run may use; results do not depend on it
};

class Run {
  public:
    /// Prepares the operators and evaluates the start (row 0 of the history). Throws InputError; Interrupted
    /// when stopped on the way.
    Run(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, RunOptions options = {},
        const Progress& progress = {}, std::stop_token stop = {});
    Run(Run&&) noexcept;
    ~Run();

    /// One iteration; says in its report how the run stands. To be called only while status() is running.
    /// What the monitor throws comes through; the run keeps its last iterate, and goes on after follow(),
    /// change() or reset(). Until then only state() and history() are to be asked.
    const StepReport& step(std::stop_token stop = {});
    /// Steps until the status is final: interrupted when stopped. Returns the last report.
    const StepReport& solve(std::stop_token stop = {});
    /// Completes the diagnostics of the present iterate, where they were left out.
    void complete();
    /// Ends the run here as interrupted, with full diagnostics of the present iterate.
    void interrupt();

    /// Goes on with other values, from the present map where it can (from the last one without tangled cells
    /// if the run has ended as tangled or diverged); else from the start. The history goes on too, with one
    /// more row for the present iterate under the new values. Returns a sentence for the user where the map
    /// could not be kept, else nothing. Throws InputError and Interrupted before anything has changed.
    std::string change(const Scenario& scenario, const Progress& progress = {}, std::stop_token stop = {});
    /// The same mesh for a monitor of the caller's own, which takes the place of the scenario's from now on
    /// (whose section then says "own"). The present map is the start (the last one without tangled cells, if
    /// the run has ended as tangled or diverged) and row 0 of a new history, so that
    /// history().back().iteration is what this monitor takes. Throws InputError if the monitor is not
    /// positive and finite, or the map has no finite residual for it; then as after a throw in step().
    void follow(std::shared_ptr<const Monitor> monitor);
    /// Back to the identity map, with a new history.
    void reset();

    RunStatus status() const { return history_.back().status; }
    const Scenario& scenario() const { return problem_.scenario; }
    const std::vector<StepReport>& history() const { return history_; }
    /// How often the history has begun anew.
    int epoch() const { return epoch_; }
    const State& state() const { return state_; }
    const Discretisation& discretisation() const { return *discretisation_; }
    /// Of the domain.
    Space space() const { return space_of(*catalogue_, problem_.scenario); }
    double setup_seconds() const { return setup_seconds_; }
    /// The present iterate as a value, measured for those who look at it even where the history leaves that
    /// out.
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
    std::shared_ptr<const Points> exact_; ///< null where no exact map is known
    State state_, last_finite_;
    State last_untangled_; ///< as far as it was measured
    std::vector<StepReport> history_;
    std::shared_ptr<const SeriesTable> series_; ///< of the reports to come
    bool measured_ = false;                     ///< the meter's last measurement is of the present iterate
    bool not_finite_ = false;
    // What the end is judged by; begins anew when values change.
    double first_residual_ = 0, best_residual_ = 0;
    std::vector<double> first_values_; ///< of the series
    int judged_from_ = 0, best_iteration_ = 0;
    int epoch_ = 0;
    double setup_seconds_ = 0, seconds_ = 0, cpu_seconds_ = 0;
    std::uint64_t version_ = 0;
};

/// The operators of a checked problem.
std::shared_ptr<const Discretisation> prepare(const Problem& problem, const Progress& progress,
                                              std::stop_token stop);

} // namespace gaspard
