// Nested iteration. If the residual is large, the iteration starts on the coarsest mesh of the domain and
// continues from level to level to the finest. If it is small, for example after a small change of the
// monitor, the iteration stays on the finest mesh. A Stepper makes the updates on each level.
//
// On a coarser level, the State has the layout of that level. One iteration is one update on any level; its
// residual refers to the level on which the iteration ends, level_series() says on which it was made.
#pragma once

#include "core/method/stepper.hpp"

namespace gaspard {

class Nested final : public Method {
  public:
    /// Makes the coarser levels. Throws Interrupted if asked to stop.
    Nested(std::unique_ptr<NonlinearProblem> problem, std::unique_ptr<Stepper> stepper, const Values& values,
           const Progress& progress, std::stop_token stop);

    void configure(const Values& values) override;
    void use_threads(int threads) override;
    double other_cpu_seconds() const override;
    State initial_state() const override { return levels_[0]->state_of(levels_[0]->start()); }
    /// Accepts states of any of its levels, from which it continues, and states that the problem adopts.
    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override;
    Evaluation step(const ProblemData& data, State& state, std::stop_token stop) override;
    const Points& positions() override;
    /// Those of the problem and level_series().
    std::vector<SeriesInfo> series() const override;
    std::vector<double> measures(const ProblemData& data) override;
    bool knows_map() const override { return levels_[0]->knows_map(); }
    std::vector<std::uint32_t> folded_cells() override;

  private:
    NonlinearProblem& here() { return *levels_[level_]; }
    void select(std::size_t level);
    void look_at(const ProblemData& data, const std::vector<double>& u);
    void go_to(std::size_t level, const std::vector<double>& u, const ProblemData& data, State& state);
    void go_up(bool arrived, const ProblemData& data, State& state);
    void restart(std::size_t level, const ProblemData& data, State& state);

    std::vector<std::unique_ptr<NonlinearProblem>> levels_; ///< the first is the finest
    std::unique_ptr<Stepper> stepper_;
    double tolerance_ = 0, enough_ = 0; ///< target residuals on the finest level, on the others
    // The current position:
    std::size_t level_ = 0;
    int iterations_here_ = 0;
    bool may_go_down_ = false;  ///< set by evaluate(), cleared by step()
    bool from_elsewhere_ = false; ///< the iteration did not begin with the start
    bool doubtful_ = false;     ///< the map came from a coarser level and has not been convex since
    std::vector<double> start_; ///< unknowns on the finest mesh before coarsening
    Iterate now_;
    bool prolonged_ = false;             ///< the finest mesh's positions are of a coarser one's potential,
    std::vector<double> u_of_positions_; ///< this one
};

/// A method type of nested iteration with the given stepper, without further rows.
MethodType nested_method(std::string name, std::string label, std::string help,
                         std::function<std::unique_ptr<Stepper>()> stepper);

} // namespace gaspard
