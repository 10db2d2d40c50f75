// A stepper makes the updates on one mesh; nested iteration (nested.hpp) uses one on every level.
#pragma once

#include "core/method/nonlinear_problem.hpp"

namespace gaspard {

/// An evaluated iterate.
struct Iterate {
    Evaluation evaluation; ///< for the original data; step size, inner iterations, note of the update
    IterateShape shape;
    bool lost = false; ///< no update was accepted; this one is a fallback
};

class Stepper {
  public:
    virtual ~Stepper() = default;
    /// Restarts for this problem, with target residual `target`. Discards all previous information.
    virtual void begin(NonlinearProblem& problem, double target) = 0;
    /// Updates the unknowns u and evaluates the result; `now` is the evaluation of u before. If asked to
    /// stop, it may leave u unchanged.
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
/// Chooses between these two.
std::unique_ptr<Stepper> make_automatic_stepper();

} // namespace gaspard
