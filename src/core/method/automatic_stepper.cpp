// Chooses between Anderson's steps and Newton's by what the iterations show, never by clocks, so that runs
// repeat. Anderson's are tried first, as they cost least. After some of them, what is still ahead is
// predicted from the rate at which the residual has decreased; where Newton's method is expected to be done
// with less work, it takes over and stays until the mesh is done. Near a solution its work follows from the
// condition of the linearised equation. Far from one it has to go along its path, which begins at the uniform
// mesh; so it takes over only after Anderson's method has had as many iterations as that path is worth.
#include "core/method/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t window = 8; ///< iterations over which the rate is taken
constexpr double far = 0.3;       ///< a residual from which Newton's method has to go along its path
// Measured, in Anderson's iterations: Newton's path for a monitor of contrast c is worth path_work log c; an
// inner iteration inner_work, a step of Newton's step_work on top of those. For each decade of the residual
// it takes condition^inner_growth inner iterations, roughly.
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
            note = "accelerated relaxation first";
            condition_ = now.shape.condition;
            may_start_anew_ = u == problem_->start();
        }
        if (!use_newton_ && newton_is_worth_it(now)) {
            choose(true);
            note = "Newton's method takes over";
            if (now.evaluation.residual > far && may_start_anew_) {
                note += " from the uniform mesh on";
                from = start_anew(data, u);
            }
        }
        Iterate next = (use_newton_ ? newton_ : anderson_)->step(data, u, from, stop);
        if (next.lost && may_start_anew_) {
            next.evaluation.note += "; Newton's method from the uniform mesh on";
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
    /// Newton's path begins at the uniform mesh.
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
        if (near_ <= window) return false; // the rate is still that of the way there
        const double inner =
            inner_work * std::pow(now.shape.condition, inner_growth) * std::log10(residual / target_);
        const double steps = 1 + std::log2(std::max(1.0, std::log(target_ / residual) / std::log(residual)));
        return anderson(target_) > inner + step_work * steps;
    }

    NonlinearProblem* problem_ = nullptr;
    double target_ = 0;
    std::unique_ptr<Stepper> anderson_, newton_;
    bool use_newton_ = false;
    int iterations_ = 0;           ///< on this mesh
    std::size_t near_ = 0;         ///< how many of the last iterates are not far from a solution
    bool may_start_anew_ = false;  ///< the way has begun at the uniform mesh, and not gone back there
    double condition_ = 0;         ///< before it
    std::deque<double> residuals_; ///< of the last iterates, on this mesh
};

} // namespace

std::unique_ptr<Stepper> make_automatic_stepper() { return std::make_unique<AutomaticStepper>(); }

} // namespace gaspard
