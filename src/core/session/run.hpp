// One problem being solved, one call at a time, on whatever thread calls.
#pragma once

#include "core/diagnostics/quality.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/session/snapshot.hpp"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

class Run {
  public:
    /// Prepares the operators and evaluates the start (row 0 of the history). Throws InputError; Interrupted
    /// when stopped on the way. `start` replaces the identity map as the first iterate.
    Run(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, const Progress& progress = {},
        std::stop_token stop = {}, const State* start = nullptr);

    /// One iteration; says in its report how the run stands. To be called only while status() is running.
    const StepReport& step(std::stop_token stop = {});
    /// Steps until the status is final; a request to stop makes it `interrupted`.
    void finish(std::stop_token stop = {});
    /// Ends the run here as interrupted, with full diagnostics of the present iterate.
    void interrupt();

    /// Goes on with other values, from the present map where it can; else from the start. Returns a sentence
    /// for the user where the map could not be kept, else nothing. Throws InputError and changes nothing.
    std::string change(const Scenario& scenario, const Progress& progress = {}, std::stop_token stop = {});
    /// Back to the identity map.
    void reset();

    RunStatus status() const { return history_.back().status; }
    const Scenario& scenario() const { return problem_.scenario; }
    const std::vector<StepReport>& history() const { return history_; }
    const State& state() const { return state_; }
    const Discretisation& discretisation() const { return *discretisation_; }
    double setup_seconds() const { return setup_seconds_; }
    /// The present iterate as a value; cheap beside a step.
    std::shared_ptr<const Snapshot> snapshot();

  private:
    void prepare(const Progress& progress, std::stop_token stop);
    void begin();
    void record(const Evaluation& evaluation, bool last);
    void measure(StepReport& report);
    RunStatus judge(const StepReport& report) const;

    std::shared_ptr<const Catalogue> catalogue_;
    Problem problem_;
    std::shared_ptr<const Discretisation> discretisation_;
    std::unique_ptr<Method> method_;
    std::optional<QualityMeter> meter_;
    State state_, last_finite_;
    std::vector<StepReport> history_;
    std::size_t judged_from_ = 0; ///< the history before a change of parameters says nothing of stalling
    double setup_seconds_ = 0, seconds_ = 0, cpu_seconds_ = 0;
    std::uint64_t version_ = 0;
};

} // namespace gaspard
