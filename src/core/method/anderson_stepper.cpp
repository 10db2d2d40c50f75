// The relaxation with Anderson acceleration. An accelerated step is accepted if the map keeps at least a
// tenth of its convexity and the residual grows by less than a factor of 10. Otherwise a plain relaxation
// step of stable length is taken, and the acceleration restarts: the stored differences are discarded.
//
// Steps accepted in this way need not converge: where the mesh does not resolve the monitor, they may wander
// without end although the relaxation converges. Therefore, if the residual has not improved for some
// iterations, they are discarded and plain steps follow from the best iterate, twice as many each
// time. So the method converges wherever the relaxation does from these iterates.
#include "core/method/anderson.hpp"
#include "core/method/stepper.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t memory = 10;      ///< number of differences stored
constexpr double least_convexity = 0.1; ///< accepted convexity after a step, relative to that before it
constexpr double largest_growth = 10;   ///< accepted growth of the residual in a step
constexpr int longest_wait = 4;         ///< maximum number of plain steps between accelerated steps
constexpr double improvement = 0.9;     ///< residual of an improvement, relative to the best one
constexpr double near = 1e-8;           ///< best residual below which only rounding errors are left
constexpr int first_patience = 60;      ///< iterations without improvement that are discarded; where the
                                        ///< acceleration converges, up to 53 were seen
constexpr int patience = 20;            ///< the same after the first time
constexpr int shortest_rest = 20;       ///< plain steps after the first of these

class AndersonStepper final : public Stepper {
  public:
    void begin(NonlinearProblem& problem, double) override {
        problem_ = &problem;
        anderson_.emplace(problem.size(), memory);
        direction_.resize(problem.size());
        next_.resize(problem.size());
        best_.resize(problem.size());
        failures_ = waiting_ = 0;
        resting_ = since_best_ = 0, rest_ = shortest_rest, patience_ = first_patience;
        best_residual_ = std::numeric_limits<double>::infinity();
    }

    Iterate step(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                 std::stop_token) override {
        if (resting_ > 0) return relax(data, u, now);
        if (now.evaluation.residual < improvement * best_residual_) keep(u, now);
        if (since_best_ >= patience_ && best_residual_ > near) return rest(data, u);
        ++since_best_;
        return accelerate(data, u, now);
    }

  private:
    /// Takes u as the iterate to which a stalled acceleration returns.
    void keep(const std::vector<double>& u, const Iterate& now) {
        std::copy(u.begin(), u.end(), best_.begin());
        best_residual_ = now.evaluation.residual;
        since_best_ = 0;
    }

    /// Discards what followed the best iterate; the first plain step from there.
    Iterate rest(const ProblemData& data, std::vector<double>& u) {
        std::copy(best_.begin(), best_.end(), u.begin());
        resting_ = rest_;
        rest_ *= 2;
        patience_ = patience;
        failures_ = waiting_ = 0;
        anderson_->restart();
        Iterate next = relax(data, u, evaluate(*problem_, data, u));
        next.evaluation.note = "the acceleration made no progress: " + std::to_string(resting_ + 1) +
                               " plain steps from the best iterate";
        next.evaluation.anew = true;
        return next;
    }

    Iterate relax(const ProblemData& data, std::vector<double>& u, const Iterate& now) {
        const double length = now.shape.stable_step;
        problem_->direction(direction_);
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += length * direction_[i];
        Iterate next = evaluate(*problem_, data, u);
        next.evaluation.step_size = length / problem_->step_unit(data);
        if (--resting_ == 0) keep(u, next); // also if it is no better: the relaxation may lead over a rise
        return next;
    }

    Iterate accelerate(const ProblemData& data, std::vector<double>& u, const Iterate& now) {
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
            next.evaluation.step_size = length / problem_->step_unit(data);
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
            next.evaluation.step_size = length / problem_->step_unit(data);
            if (halvings == 0 || acceptable(next)) return next;
        }
    }

    NonlinearProblem* problem_ = nullptr;
    std::optional<Anderson> anderson_;
    std::vector<double> direction_, next_;
    int failures_ = 0, waiting_ = 0; ///< rejected steps in a row; plain steps left
    std::vector<double> best_;       ///< the best iterate of the acceleration
    double best_residual_ = 0;
    int since_best_ = 0;         ///< accelerated steps since then
    int patience_ = 0;           ///< how many of them there may be
    int resting_ = 0, rest_ = 0; ///< plain steps left; number of them after the next stall
};

} // namespace

std::unique_ptr<Stepper> make_anderson_stepper() { return std::make_unique<AndersonStepper>(); }

} // namespace gaspard
