// The relaxation with Anderson acceleration. An accelerated step is accepted if the map keeps at least a
// tenth of its convexity and the residual grows by less than a factor of 10. Otherwise a plain relaxation
// step of stable length is taken, and the acceleration restarts: the stored differences are discarded.
#include "core/method/anderson.hpp"
#include "core/method/stepper.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t memory = 10;      ///< number of differences stored
constexpr double least_convexity = 0.1; ///< accepted convexity after a step, relative to that before it
constexpr double largest_growth = 10;   ///< accepted growth of the residual in a step
constexpr int longest_wait = 4;         ///< maximum number of plain steps between accelerated steps

class AndersonStepper final : public Stepper {
  public:
    void begin(NonlinearProblem& problem, double) override {
        problem_ = &problem;
        anderson_.emplace(problem.size(), memory);
        direction_.resize(problem.size());
        next_.resize(problem.size());
        failures_ = waiting_ = 0;
    }

    Iterate step(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                 std::stop_token) override {
        const auto acceptable = [&](const Iterate& next) {
            return next.evaluation.residual < largest_growth * now.evaluation.residual &&
                   next.shape.admissibility > least_convexity * now.shape.admissibility;
        };
        bool forget = false;
        double length = now.shape.stable_step;
        problem_->direction(direction_);
        anderson_->propose(u, direction_, problem_->residual(), length, next_);
        std::swap(u, next_); // next_ now holds the iterate before the step
        Iterate next;
        if (waiting_ == 0) {
            next = evaluate(*problem_, data, u);
            next.evaluation.step_size = length;
            if (acceptable(next)) {
                failures_ = 0;
                return next;
            }
            waiting_ = std::min(failures_, longest_wait);
            ++failures_;
            forget = true;
        } else {
            --waiting_;
        }

        // A plain step; if the iterate is convex, it is halved until the result is acceptable.
        int halvings = now.shape.admissibility > 0 ? 4 : 0;
        if (anderson_->count() == 0) length /= 2, halvings = std::max(0, halvings - 1);
        if (forget) anderson_->forget_differences();
        for (;; length /= 2, --halvings) {
            for (std::size_t i = 0; i < u.size(); ++i) u[i] = next_[i] + length * direction_[i];
            next = evaluate(*problem_, data, u);
            next.evaluation.step_size = length;
            if (halvings == 0 || acceptable(next)) return next;
        }
    }

  private:
    NonlinearProblem* problem_ = nullptr;
    std::optional<Anderson> anderson_;
    std::vector<double> direction_, next_;
    int failures_ = 0, waiting_ = 0; ///< rejected steps in a row; plain steps left
};

} // namespace

std::unique_ptr<Stepper> make_anderson_stepper() { return std::make_unique<AndersonStepper>(); }

} // namespace gaspard
