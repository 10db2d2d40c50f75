// Chooses between Anderson's steps and Newton's by what the iterations show, never by clocks, so that runs
// repeat. Anderson's are tried first, as they cost least. After some of them, what is still ahead is
// predicted from the rate at which the residual has decreased; where Newton's method is expected to be done
// with less work, it takes over and stays until the mesh is done. Work is counted in evaluations of the
// equation, of which an inner iteration of the linear solver is worth two.
#include "core/method/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t window = 8; ///< iterations over which the rate is taken
constexpr double inner_work = 2;  ///< of an inner iteration

class AutomaticStepper final : public Stepper {
  public:
    AutomaticStepper() : anderson_(make_anderson_stepper()), newton_(make_newton_stepper()) {}

    void begin(Equation& equation, double target) override {
        equation_ = &equation;
        target_ = target;
        choose(false);
        begun_ = false;
    }

    Iterate step(const Monitor& monitor, std::vector<double>& phi, const Iterate& now,
                 std::stop_token stop) override {
        std::string note;
        if (!std::exchange(begun_, true)) note = "accelerated relaxation first";
        if (!use_newton_ && newton_is_worth_it(now)) {
            choose(true);
            note = "Newton's method takes over";
        }
        Iterate next = (use_newton_ ? newton_ : anderson_)->step(monitor, phi, now, stop);
        next.lost = false; // Newton's method relaxes then, and tries again
        residuals_.push_back(next.evaluation.residual);
        if (residuals_.size() > window + 1) residuals_.pop_front();
        if (!note.empty() && !next.evaluation.note.empty()) note += "; ";
        next.evaluation.note = note + next.evaluation.note;
        return next;
    }

  private:
    void choose(bool newton) {
        use_newton_ = newton;
        residuals_.clear();
        (newton ? newton_ : anderson_)->begin(*equation_, target_);
    }

    bool newton_is_worth_it(const Iterate& now) const {
        const double residual = now.evaluation.residual;
        if (residuals_.size() <= window || !(now.shape.slowest > 0)) return false;
        const double rate = std::pow(residual / residuals_.front(), 1.0 / static_cast<double>(window));
        const double far = std::log(target_ / residual);
        const double anderson = rate < 1 ? far / std::log(rate) : std::numeric_limits<double>::infinity();
        // Inner iterations grow with the root of the condition number, which the preconditioner halves.
        const double inner = 4 + 2 * std::sqrt(now.shape.fastest / now.shape.slowest);
        const double steps =
            residual < 0.3 ? 1 + std::log2(far / std::log(residual)) : 8 - 2 * std::log(residual);
        return anderson > inner_work * inner * steps;
    }

    Equation* equation_ = nullptr;
    double target_ = 0;
    std::unique_ptr<Stepper> anderson_, newton_;
    bool use_newton_ = false, begun_ = false;
    std::deque<double> residuals_; ///< of the last iterates, on this mesh
};

} // namespace

std::unique_ptr<Stepper> make_automatic_stepper() { return std::make_unique<AutomaticStepper>(); }

} // namespace gaspard
