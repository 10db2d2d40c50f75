// A stepper makes the updates on one mesh; nested iteration (nested.hpp) uses one on every level.
#pragma once

#include "core/method/nonlinear_problem.hpp"

namespace gaspard {

/// An iterate, evaluated.
struct Iterate {
    Evaluation evaluation; ///< for the data itself; with the update's step size, inner iterations and note
    IterateShape shape;
    bool lost = false; ///< the update was made only because one has to be: no better one is known
};

class Stepper {
  public:
    virtual ~Stepper() = default;
    /// The updates from here on are for this problem, down to a residual of `target`. Forgets everything.
    virtual void begin(NonlinearProblem& problem, double target) = 0;
    /// One update of the unknowns u; `now` is the iterate last evaluated. Evaluates the result. If it is asked
    /// to stop, u may stay as it is.
    virtual Iterate step(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                         std::stop_token stop) = 0;
};

inline Iterate evaluate(NonlinearProblem& problem, const ProblemData& data, const std::vector<double>& u) {
    Iterate iterate;
    iterate.evaluation = problem.evaluate(data, u);
    iterate.shape = problem.shape();
    return iterate;
}

std::unique_ptr<Stepper> make_anderson_stepper();
std::unique_ptr<Stepper> make_newton_stepper();
/// Chooses between the two.
std::unique_ptr<Stepper> make_automatic_stepper();

} // namespace gaspard
