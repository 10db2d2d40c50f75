// One way of making updates on one mesh: what the nested methods (method/nested.hpp) are made of.
#pragma once

#include "core/method/equation.hpp"

namespace gaspard {

/// An iterate as its equation sees it.
struct Iterate {
    Evaluation evaluation; ///< of the monitor itself; with the update's step size, inner iterations and note
    Ellipticity shape;
    bool lost = false; ///< the update was made because one has to be: no way on is known
};

class Stepper {
  public:
    virtual ~Stepper() = default;
    /// From here on, the updates are of this equation, down to a residual of `target`; nothing is remembered.
    virtual void begin(Equation& equation, double target) = 0;
    /// One update of phi, `now` the iterate that the equation has last evaluated; evaluates what came out.
    /// Where it is stopped, phi may stay as it is.
    virtual Iterate step(const Monitor& monitor, std::vector<double>& phi, const Iterate& now,
                         std::stop_token stop) = 0;
};

/// The equation evaluated at phi.
inline Iterate look(Equation& equation, const Monitor& monitor, const std::vector<double>& phi) {
    Iterate iterate;
    iterate.evaluation = equation.evaluate(monitor, phi);
    iterate.shape = equation.ellipticity();
    return iterate;
}

std::unique_ptr<Stepper> make_anderson_stepper();
std::unique_ptr<Stepper> make_newton_stepper();
/// Chooses between the two.
std::unique_ptr<Stepper> make_automatic_stepper();

} // namespace gaspard
