// Chooses between Anderson's and Newton's method from the observed convergence, not from timings, so that
// runs are reproducible. Anderson's method is tried first, because its iterations are cheapest. Then the
// remaining number of iterations is predicted from the rate at which the residual has decreased. The stepper
// changes to Newton's method, for the rest of the iterations on this mesh, if it is expected to need less
// work. Near a solution, the work of Newton's method follows from the condition number of the linearised
// equation. Far from a solution, it needs a continuation that starts at the uniform mesh; the stepper
// therefore changes only after Anderson's method has used as many iterations as the continuation is expected
// to cost.
#include "core/method/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t window = 8; ///< number of iterations used to estimate the rate
constexpr double far = 0.3;       ///< residual above which Newton's method needs its continuation
// Measured costs, in iterations of Anderson's method. c: contrast of the monitor; condition: condition number
// of the linearised equation.
//
//   continuation                        path_work log c
//   inner (GMRES) iteration             inner_work
//   Newton step, without its inner ones step_work
//   inner iterations per decade         condition^inner_growth
constexpr double path_work = 30, inner_work = 1.4, inner_growth = 0.4, step_work = 2.5;

class AutomaticStepper final : public Stepper {
  public:
    AutomaticStepper() : anderson_(make_anderson_stepper()), newton_(make_newton_stepper()) {}

    void begin(NonlinearProblem& problem, double target) override {
        problem_ = &problem;
        target_ = target;
        iterations_ = 0, near_ = 0;
        choose(false);
    }

    Iterate step(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                 std::stop_token stop) override {
        std::string note;
        Iterate from = now;
        if (iterations_ == 0) {
            note = "starting with accelerated relaxation";
            condition_ = now.shape.condition;
            may_start_anew_ = u == problem_->start();
        }
        if (!use_newton_ && newton_is_worth_it(now)) {
            choose(true);
            note = "Newton's method takes over";
            if (now.evaluation.residual > far && may_start_anew_) {
                note += ", restarting at the uniform mesh";
                from = start_anew(data, u);
            }
        }
        Iterate next = (use_newton_ ? newton_ : anderson_)->step(data, u, from, stop);
        if (next.lost && may_start_anew_) {
            next.evaluation.note += "; restarting with Newton's method at the uniform mesh";
            const Evaluation lost = next.evaluation;
            next = start_anew(data, u);
            next.evaluation.step_size = lost.step_size;
            next.evaluation.inner_iterations = lost.inner_iterations;
            next.evaluation.note = lost.note;
        }
        ++iterations_;
        near_ = next.evaluation.residual > far ? 0 : near_ + 1;
        residuals_.push_back(next.evaluation.residual);
        if (residuals_.size() > window + 1) residuals_.pop_front();
        if (!note.empty() && !next.evaluation.note.empty()) note += "; ";
        next.evaluation.note = note + next.evaluation.note;
        return next;
    }

  private:
    /// Changes to Newton's method, whose continuation starts at the uniform mesh.
    Iterate start_anew(const ProblemData& data, std::vector<double>& u) {
        may_start_anew_ = false;
        choose(true);
        u = problem_->start();
        return evaluate(*problem_, data, u);
    }

    void choose(bool newton) {
        use_newton_ = newton;
        residuals_.clear();
        (newton ? newton_ : anderson_)->begin(*problem_, target_);
    }

    bool newton_is_worth_it(const Iterate& now) const {
        const double residual = now.evaluation.residual;
        if (residuals_.size() <= window) return false;
        const double rate = std::pow(residual / residuals_.front(), 1.0 / static_cast<double>(window));
        const auto anderson = [&](double to) {
            if (residual <= to) return 0.0;
            return rate < 1 ? std::log(to / residual) / std::log(rate)
                            : std::numeric_limits<double>::infinity();
        };
        if (residual > far) {
            const double path = path_work * std::log(condition_);
            return iterations_ > path && anderson(far) > path / 2;
        }
        if (near_ <= window) return false; // the rate still includes iterations far from a solution
        const double inner =
            inner_work * std::pow(now.shape.condition, inner_growth) * std::log10(residual / target_);
        const double steps = 1 + std::log2(std::max(1.0, std::log(target_ / residual) / std::log(residual)));
        return anderson(target_) > inner + step_work * steps;
    }

    NonlinearProblem* problem_ = nullptr;
    double target_ = 0;
    std::unique_ptr<Stepper> anderson_, newton_;
    bool use_newton_ = false;
    int iterations_ = 0;           ///< number of iterations on this mesh
    std::size_t near_ = 0;         ///< number of consecutive last iterates near a solution
    bool may_start_anew_ = false;  ///< started at the uniform mesh and has not restarted
    double condition_ = 0;         ///< condition number at the first iterate
    std::deque<double> residuals_; ///< residuals of the last iterates on this mesh
};

} // namespace

std::unique_ptr<Stepper> make_automatic_stepper() { return std::make_unique<AutomaticStepper>(); }

} // namespace gaspard
