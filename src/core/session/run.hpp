// A run solves one problem, step by step, on the calling thread.
//
//     Run run(catalogue, scenario);                            // prepares; the start is row 0 of the history
//     while (run.status() == RunStatus::running) run.step();   // or run.solve()
//     const auto mesh = run.snapshot();                        // x, fields, numbers
//
// For a mesh that follows a simulation, call follow() once per time step with the current monitor, then
// solve(); the map of the last time step is the start (examples/follow_a_feature.cpp).
//
// If the scenario has time (scenario/clock.hpp), step() first solves for its start. From then on every step()
// is a time step, whatever number of iterations it takes, and a row of the history; the run ends at the end
// of the time.
//
// Different runs are independent and may be used on different threads; each run may be used by one thread at
// a time. Snapshots are immutable and may be shared between threads.
#pragma once

#include "core/base/export.hpp"
#include "core/diagnostics/interpolation_error.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/session/snapshot.hpp"

#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

class CellQualityMeter;
struct Following; // core/session/following.hpp
class QualityMeter;
struct SplinePatch; // core/spline/spline_patch.hpp

struct RunOptions {
    std::optional<State> start{}; ///< the first iterate; nullopt: the identity map
    int threads = 1;              ///< maximum number of threads; results do not depend on it
    /// The caller's monitor instead of the scenario's, as after follow(); null: the scenario's.
    std::shared_ptr<const Monitor> monitor{};
    /// The caller's patch as domain: domain.type becomes "spline-patch" (with default values if the scenario
    /// has another) and domain.file the patch as JSON, without domain.patch and domain.control_points; null:
    /// the scenario's domain.
    std::shared_ptr<const SplinePatch> patch{};
};

class Run {
  public:
    /// Prepares the operators and evaluates the start (row 0 of the history). Throws InputError, and
    /// Interrupted if asked to stop.
    Run(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, RunOptions options = {},
        const Progress& progress = {}, std::stop_token stop = {});
    Run(Run&&) noexcept;
    ~Run();

    // Exceptions, also those of the caller's monitor, propagate from every function and leave the run as it
    // was before the call.

    /// Makes one iteration, or one time step, and returns its report with the new status. Requires status()
    /// to be running.
    /// Throws InputError if the caller's monitor is not positive and finite somewhere, and Interrupted if
    /// asked to stop in the middle of a step that takes long. Time passes by so many time steps at once.
    const StepReport& step(std::stop_token stop = {}, int time_steps = 1);
    /// Steps until the status is final (interrupted if asked to stop). Returns the last report.
    const StepReport& solve(std::stop_token stop = {});
    /// Computes the diagnostics (method.diagnostics) of the current iterate if they were skipped.
    void complete();
    /// Ends the run with status interrupted and the diagnostics of the current iterate.
    void interrupt();

    /// Continues with other values from the current map, transferred to the new problem; from the last map
    /// without tangled cells if that one has some or the run has diverged; from the identity map if no
    /// transfer is possible. Starts a new history, so that history().back().iteration is the number of
    /// iterations for these values; its first row is the map under the new values, with diagnostics up to
    /// `at_most`. Values that the solution does not depend on, such as those of the view, leave the history
    /// as it is. Returns a message for the user if the map could not be transferred, else an empty string.
    /// `reread`: files are read anew even if no value has changed. Throws InputError, and Interrupted if
    /// asked to stop.
    std::string change(const Scenario& scenario, const Progress& progress = {}, std::stop_token stop = {},
                       Diagnostics at_most = Diagnostics::full, bool reread = false);
    /// Replaces the monitor of the scenario by that of the caller; the type of section "monitor" is then
    /// "own". Starts a new history from the current map (from the last one without tangled cells if the run
    /// is tangled or diverged, or if the last step threw), so that history().back().iteration is the number
    /// of iterations for this monitor. Throws InputError if the monitor is not positive and finite, with the
    /// point, or if the residual of the map is not finite for it; Interrupted if asked to stop.
    void follow(std::shared_ptr<const Monitor> monitor, std::stop_token stop = {});
    /// Restarts from the identity map, at the start of the time, with a new history.
    void reset();
    /// Restarts from a state, such as that of a file (core/io/state_file.hpp), with a new history. Throws
    /// InputError if it does not fit to the problem, and Interrupted if asked to stop.
    void start_from(const State& state, std::stop_token stop = {});
    /// Goes on from the state of a time step, or of one near it, at the time t (nullopt: the start), with a
    /// new history.
    void go_on_from(const State& state, std::optional<double> t, std::stop_token stop = {});
    /// The time of the current mesh; nullopt if the scenario has none.
    std::optional<double> time() const;
    /// Whether the next step is a time step.
    bool moves() const;

    RunStatus status() const { return history_.back().status; }
    const Scenario& scenario() const { return now_.problem.scenario; }
    /// Times include the evaluation of the start, by the constructor, reset(), follow() or change(). Of very
    /// many time steps, some are left out (session/history_thinning.hpp); the first and the last are there.
    const std::vector<StepReport>& history() const { return history_; }
    /// Number of times that a new history has been started.
    int epoch() const { return epoch_; }
    const State& state() const { return now_.state; }
    const Discretisation& discretisation() const { return *now_.discretisation; }
    /// The space of the domain.
    Space space() const { return space_of(*catalogue_, scenario()); }
    double setup_seconds() const { return setup_seconds_; }
    /// What the monitor says about itself; null: nothing.
    std::shared_ptr<const MonitorReport> monitor_report() const { return now_.data.report; }
    /// The function whose interpolation error the mesh is to reduce (Monitor::solution), else the monitor.
    std::shared_ptr<const ScalarFunction> solution() const;
    /// Its interpolation errors on the uniform mesh and on that of the current iterate, measured unless they
    /// are known to this tolerance; null if method.interpolation is off or method.diagnostics is not full.
    /// The report and the snapshots to come have them, too. Of `options`, the threads are those of the run.
    /// Throws InputError if the function is not finite somewhere, Interrupted if asked to stop.
    std::shared_ptr<const InterpolationComparison> interpolation(InterpolationOptions options = {});
    /// The current iterate as a value, with the diagnostics of method.diagnostics, or fewer, even if the
    /// history skips them.
    std::shared_ptr<const Snapshot> snapshot(Diagnostics at_most = Diagnostics::full);

  private:
    /// What the end is judged by; begins anew with the history.
    struct Judging {
        /// Values of the criterion (SeriesTable::criterion).
        double first = std::numeric_limits<double>::infinity(), best = first;
        std::vector<double> first_values{}; ///< of the series
        int best_iteration = 0;
        bool not_finite = false; ///< the last update was discarded
    };
    /// All that changes when values do. It is made aside and replaces the present one when nothing can fail
    /// any more.
    struct Course {
        Problem problem;
        std::shared_ptr<const Monitor> own{}; ///< the caller's monitor; null: the scenario's
        ProblemData data{};
        std::shared_ptr<const Discretisation> discretisation{};
        std::shared_ptr<Method> method{};
        std::shared_ptr<QualityMeter> meter{};
        std::shared_ptr<const CellQualityMeter> shapes{}; ///< if method.cell_quality is on; otherwise null
        std::shared_ptr<const Points> exact{};            ///< null if no exact map is known
        std::shared_ptr<const SeriesTable> series{};      ///< of the reports to come
        State state{};
        /// As in Snapshot, of the last measurement.
        std::shared_ptr<const std::vector<std::uint32_t>> tangled{};
        State untangled{}; ///< the last measured iterate without tangled cells
        Judging judging{};
        std::optional<Diagnostics>
            measured{}; ///< what the meter's last measurement is of the present iterate
        std::shared_ptr<const Following> following{}; ///< null: the scenario has no time
    };

    /// What has been measured of interpolation errors.
    struct Interpolated {
        std::shared_ptr<const Mesh> mesh{};
        std::shared_ptr<const Monitor> monitor{}; ///< of `uniform` and `last`
        double tolerance = 0;
        std::shared_ptr<const InterpolationError> uniform{};
        std::shared_ptr<const InterpolationComparison> last{};
    };

    class Timer;

    static Diagnostics diagnostics(const Course& course);
    MonitorContext monitor_context(const Course& course, const Progress& progress,
                                   std::stop_token stop) const;
    std::unique_ptr<Method> make_method(const Course& course, const Progress& progress,
                                        std::stop_token stop) const;
    std::shared_ptr<QualityMeter> make_meter(const Course& course) const;
    void prepare_reports(Course& course) const;
    const MethodType& method_type(const Course& course) const;
    bool returns() const;
    bool transfer(Course& course) const;
    Evaluation first_look(const Course& course, std::stop_token stop) const;
    static State adopted(const Course& course, const State& start);
    void restart(Course next, std::stop_token stop);
    void begin_history(Course next, std::string note, std::stop_token stop, Diagnostics at_most);
    void put_in_place(Course&& next) noexcept;
    void refresh();
    StepReport report(Course& course, const Evaluation& evaluation, int iteration, std::string note,
                      Diagnostics at_most = Diagnostics::full) const;
    static void note_folds(const Course& course, StepReport& report);
    static void note_advice(const Course& course, StepReport& report);
    void take_series(const Course& course, const SeriesValues& values, StepReport& report) const;
    void measure(Course& course, StepReport& report, Diagnostics at_most) const;
    void add_fields_of_method(Snapshot& snapshot);
    static bool interpolates(const Course& course);
    static bool measures_shapes(const Course& course);
    static void prepare_shapes(Course& course);
    static SeriesValues shapes(const Course& course);
    void add_interpolation(Snapshot& snapshot) const;
    void add_fields_of_monitor(Snapshot& snapshot) const;
    bool out_of_bounds(const Course& course, const StepReport& report) const;
    RunStatus judge(Course& course, const StepReport& report, Ending ending, std::string& note) const;
    void take_back(Evaluation& evaluation, std::string& note);
    // run_time.cpp
    struct StepMesh; // time_step.hpp
    class TimeStep;
    ProblemData data_of(const Course& course, const Progress& progress, std::stop_token stop) const;
    void set_clock(Course& course, std::optional<double> t) const;
    static void restart_following(Course& course);
    static bool arrives(const Course& course, const StepReport& report);
    static void arrive(Course& course, StepReport& report);
    static void add_time(const Course& course, StepReport& report);
    struct FirstAttempt;
    const StepReport& advance(std::stop_token stop, int time_steps, const FirstAttempt* first = nullptr);
    StepReport report_step(Course& next, const StepMesh& mesh, int iteration, int time_steps) const;
    void end_time(const Course& course, StepReport& report) const;
    const StepReport& give_up_time(RunStatus status, const std::string& note, int iterations,
                                   const Timer& timer);
    void find_exact(Course& course) const;
    static void add_velocity(const Course& course, Snapshot& snapshot);

    std::shared_ptr<const Catalogue> catalogue_;
    int threads_ = 1;
    std::shared_ptr<FileCache> files_ = std::make_shared<FileCache>(); ///< of the monitors
    Course now_;
    Interpolated interpolated_;
    State last_finite_;
    std::vector<StepReport> history_;
    bool stale_ = false;  ///< an exception has left the method at another state or other data
    bool failed_ = false; ///< the last step threw
    int epoch_ = 0;
    double setup_seconds_ = 0;
    std::uint64_t version_ = 0;
};

/// Makes the discretisation of a checked problem. Throws InputError, and Interrupted if asked to stop.
std::shared_ptr<const Discretisation> prepare(const Problem& problem, const Progress& progress,
                                              std::stop_token stop);

} // namespace GASPARD_API
