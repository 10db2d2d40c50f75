// One time step of a run, for run_time.cpp.
#pragma once

#include "core/session/following.hpp"
#include "core/session/run.hpp"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

/// The mesh of a time step, and what it took.
struct Run::StepMesh {
    Evaluation evaluation; ///< of the course's state
    bool solved = false;
    int iterations = 0, inner_iterations = 0; ///< of all attempts
    double monitor_seconds = 0;
    std::vector<StepTolerance::Sample> samples{}; ///< if asked for: at least one
};

/// Changes the state and the data of a course from one time to another.
class [[gnu::visibility("hidden")]] Run::TimeStep { // the library does not export it
  public:
    TimeStep(const Run& run, Course& course, std::stop_token stop);
    /// To the time of `following`, from its time before. A mesh that is not solved is that of the attempt
    /// that came nearest.
    StepMesh make(const Following& following);
    /// So far, of all attempts.
    int iterations() const { return iterations_; }

  private:
    class LooserMethod;
    struct Attempt {
        Evaluation evaluation;
        State state;
        bool solved = false;
        double criterion = 0;
        std::vector<StepTolerance::Sample> samples{};
    };

    Attempt follow(const Following& following);
    Attempt follow_in_parts(const Following& following, const State& before, double aim, bool samples,
                            int parts);
    Attempt relax(double dt, const Points& nodes);
    Attempt solve(State start, double aim, bool samples);
    Evaluation step();
    void set_time(const Following& following, double t);
    double smallest() const;
    double criterion(const Evaluation& evaluation) const;
    double criterion_of(const State& state);
    StepTolerance::Sample sample(double residual);

    const Run& run_;
    Course& course_;
    std::stop_token stop_;
    const Values& time_;
    const std::string& rule_;
    int iterations_ = 0, inner_iterations_ = 0;
    double monitor_seconds_ = 0;
};

} // namespace gaspard
