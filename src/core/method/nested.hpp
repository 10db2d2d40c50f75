// Nested iteration: a map that is far from a solution goes down to the coarsest mesh of its domain and from
// there up again, mesh by mesh; a map that is near, as when the monitor moves a little, stays where it is.
// What makes the updates on each mesh is a Stepper.
//
// On the way the State is one of the coarser mesh. An iteration is one update, on whatever mesh; the report
// is of the mesh on which it ends.
#pragma once

#include "core/method/stepper.hpp"

namespace gaspard {

class Nested final : public Method {
  public:
    /// Makes the coarser meshes; throws Interrupted when asked to stop.
    Nested(std::unique_ptr<NonlinearProblem> problem, std::unique_ptr<Stepper> stepper, const Values& values,
           const Progress& progress, std::stop_token stop);

    void configure(const Values& values) override;
    void use_threads(int threads) override;
    double other_cpu_seconds() const override;
    State initial_state() const override { return levels_[0]->state_of(levels_[0]->start()); }
    /// From any of its meshes, where the way up goes on, and from whatever the problem adopts.
    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override;
    Evaluation step(const ProblemData& data, State& state, std::stop_token stop) override;
    const Points& positions() override;
    std::vector<SeriesInfo> series() const override { return levels_[0]->series(); }
    std::vector<double> measures(const ProblemData& data) override;

  private:
    NonlinearProblem& here() { return *levels_[level_]; }
    void select(std::size_t level);
    void look_at(const ProblemData& data, const std::vector<double>& u);
    void go_to(std::size_t level, const std::vector<double>& u, const ProblemData& data, State& state);
    void go_up(bool arrived, const ProblemData& data, State& state);

    std::vector<std::unique_ptr<NonlinearProblem>> levels_; ///< the first is the one that is asked for
    std::unique_ptr<Stepper> stepper_;
    double tolerance_ = 0, enough_ = 0; ///< on the finest mesh, on the others
    // Where the way has come to:
    std::size_t level_ = 0;
    int iterations_here_ = 0;
    bool may_go_down_ = false;  ///< not again before somebody evaluates
    std::vector<double> start_; ///< the potential on the finest mesh from which it went down
    Iterate now_;
    bool prolonged_ = false;             ///< the finest mesh's positions are of a coarser one's potential,
    std::vector<double> u_of_positions_; ///< this one
};

/// A method type of this kind, without rows of its own.
MethodType nested_method(std::string name, std::string label, std::string help,
                         std::function<std::unique_ptr<Stepper>()> stepper);

} // namespace gaspard
