// Newton's method with the full linearisation of the discrete equation (nonlinear_problem.hpp), sigma
// eliminated exactly:
//
//   -(dr/dphi) dphi = r,   phi -> phi + s dphi
//
// Near a solution, s = 1 is accepted and convergence is quadratic. Far from a solution, the full
// linearisation loses convexity, as McRae et al. found; therefore a continuation in powers of the monitor is
// used: m^t, from t = 0, for which the uniform mesh is the solution, to t = 1. For each t one Newton step is
// made. It is accepted if the map stays convex and the residual for m^t is below `close`; then t increases
// further. Otherwise the step is discarded and the increment of t halved. Where the start does not solve the
// problem for t = 0, damped steps for it come first.
#include "core/linear/gmres.hpp"
#include "core/method/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

constexpr double convexity_kept = 0.1;       ///< accepted convexity after a step, relative to that before it
constexpr double convexity_kept_first = 0.3; ///< the same towards the solution for t = 0
constexpr double close = 0.3;                ///< residual for m^t below which a step is accepted
constexpr double aim = 0.1;                  ///< residual for m^t at which the increment of t aims
constexpr double shortest = 1.0 / 64;        ///< smallest s in the line search
constexpr double least_advance = 1e-3;       ///< smallest increment of t
constexpr double loosest = 0.1;              ///< largest tolerance of the linear solver
constexpr std::size_t restart_length = 30;   ///< of GMRES
constexpr int most_inner = 300, most_inner_far = 100;         ///< max. GMRES iterations near a solution; else
constexpr int fewest_relaxations = 8, most_relaxations = 128; ///< steps after a failed Newton step

class NewtonStepper final : public Stepper {
  public:
    void begin(NonlinearProblem& problem, double target) override {
        problem_ = &problem;
        target_ = target;
        on_path_ = begun_ = false;
        resting_ = 0, rest_ = fewest_relaxations;
    }

    Iterate step(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                 std::stop_token stop) override {
        if (update_.size() != u.size()) {
            gmres_.emplace(u.size(), restart_length);
            update_.resize(u.size());
            before_.resize(u.size());
        }
        inner_ = 0;
        note_.clear();
        if (!std::exchange(begun_, true) && u == problem_->start() && now.evaluation.residual > close)
            set_out(now);
        before_ = u;
        if (resting_ > 0) {
            --resting_;
            return relax(data, u, now);
        }
        Iterate next = on_path_ ? along_path(data, u, stop) : directly(data, u, now, stop);
        next.evaluation.inner_iterations = inner_;
        next.evaluation.note = std::move(note_);
        return next;
    }

  private:
    void set_out(const Iterate& now) {
        on_path_ = true;
        t_ = 0;
        advance_ = std::min(1.0, close / now.evaluation.residual);
        tell("continuation in powers of the monitor, starting with " + problem_->name_of_continued(advance_));
    }
    void tell(const std::string& sentence) { note_ += (note_.empty() ? "" : "; ") + sentence; }

    /// Computes update_ for the data with which the problem was last evaluated. Returns whether it is usable.
    bool solve(const ProblemData& data, double residual, std::stop_token stop) {
        problem_->linearise(data, NonlinearProblem::Linearised::fully);
        // Tolerance proportional to the residual, for quadratic convergence; not smaller than the target
        // needs.
        const double tolerance = std::clamp(residual, std::min(loosest, 0.1 * target_ / residual), loosest);
        const bool far = residual > close; // then the step must be solved within most_inner_far
        const auto result =
            gmres_->solve([&](auto v, auto out) { problem_->derivative(v, out); },
                          [&](auto v, auto out) { problem_->precondition(v, out); }, problem_->residual(),
                          update_, {tolerance, far ? most_inner_far : most_inner}, stop);
        inner_ += result.iterations;
        return std::isfinite(result.residual) && (result.converged || !far);
    }
    void go(std::vector<double>& u, double length) {
        for (std::size_t i = 0; i < u.size(); ++i) u[i] = before_[i] + length * update_[i];
    }

    /// Newton step with a line search: s is halved until the residual decreases and the share `kept` of the
    /// convexity is left. If there is no such s, u is as before and the result empty.
    std::optional<Iterate> damped(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                                  double kept, std::stop_token stop) {
        const bool solved = solve(data, now.evaluation.residual, stop);
        for (double s = 1; solved && !stop.stop_requested() && s >= shortest; s /= 2) {
            go(u, s);
            Iterate next = evaluate(*problem_, data, u);
            next.evaluation.step_size = s;
            if (next.shape.admissibility > kept * now.shape.admissibility &&
                next.evaluation.residual < (1 - s / 10) * now.evaluation.residual)
                return next;
        }
        u = before_;
        return std::nullopt;
    }

    /// Newton step for m itself.
    Iterate directly(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                     std::stop_token stop) {
        if (auto next = damped(data, u, now, convexity_kept, stop)) return *std::move(next);
        Iterate same = evaluate(*problem_, data, u);
        if (stop.stop_requested()) return same;
        return give_way(data, u, same);
    }

    /// One Newton step of the continuation, for m^t with an increased t.
    Iterate along_path(const ProblemData& data, std::vector<double>& u, std::stop_token stop) {
        while (!stop.stop_requested()) {
            const double t = std::min(1.0, t_ + advance_);
            const ProblemData of_step = t < 1 ? problem_->continued(data, t) : data;
            const Iterate before = evaluate(*problem_, of_step, u);
            const bool solved = solve(of_step, before.evaluation.residual, stop);
            if (stop.stop_requested()) break;
            if (solved) go(u, 1); // otherwise the update may not be finite
            Iterate next = solved ? evaluate(*problem_, of_step, u) : before;
            const double residual = next.evaluation.residual;
            if (solved && residual < close &&
                next.shape.admissibility > convexity_kept * before.shape.admissibility) {
                t_ = t;
                advance_ *= std::clamp(std::sqrt(aim / residual), 0.5, 3.0);
                if (t == 1) {
                    on_path_ = false;
                    tell("continuation finished, solving for the monitor itself");
                } else {
                    next = evaluate(*problem_, data, u);
                }
                next.evaluation.step_size = 1;
                return next;
            }
            u = before_;
            if (const auto length = towards_first(data, u, stop)) {
                Iterate of_data = evaluate(*problem_, data, u);
                of_data.evaluation.step_size = *length;
                return of_data;
            }
            advance_ = (t - t_) / 2;
            if (advance_ < least_advance) {
                tell("continuation stopped at " + problem_->name_of_continued(t_));
                return give_way(data, u, evaluate(*problem_, data, u));
            }
            tell("the step to " + problem_->name_of_continued(t) + " failed, trying " +
                 problem_->name_of_continued(t_ + advance_));
        }
        u = before_;
        return evaluate(*problem_, data, u);
    }

    /// Where the start does not solve the problem for t = 0, as between shapes that no affine map exchanges:
    /// a damped step towards its solution, and the length of this step.
    std::optional<double> towards_first(const ProblemData& data, std::vector<double>& u,
                                        std::stop_token stop) {
        if (t_ > 0) return std::nullopt;
        const ProblemData first = problem_->continued(data, 0);
        const Iterate now = evaluate(*problem_, first, u);
        if (now.evaluation.residual < aim) return std::nullopt;
        const auto next = damped(first, u, now, convexity_kept_first, stop);
        if (!next) return std::nullopt;
        tell("a step for " + problem_->name_of_continued(0));
        return next->evaluation.step_size;
    }

    /// If no Newton step is accepted: some relaxation steps, which use the Laplacian instead of the
    /// linearisation; then Newton steps for m itself.
    Iterate give_way(const ProblemData& data, std::vector<double>& u, const Iterate& now) {
        on_path_ = false;
        resting_ = rest_ - 1;
        tell("no Newton step was accepted: " + std::to_string(rest_) + " relaxation steps");
        rest_ = std::min(2 * rest_, most_relaxations);
        Iterate next = relax(data, u, now);
        next.lost = true;
        return next;
    }
    Iterate relax(const ProblemData& data, std::vector<double>& u, const Iterate& now) {
        double length = now.shape.stable_step;
        problem_->direction(update_);
        go(u, length);
        Iterate next = evaluate(*problem_, data, u);
        const auto grows = [&] { return !(next.evaluation.residual < now.evaluation.residual); };
        while (problem_->begins_anew() && grows() && length > 0) {
            length = length > shortest * now.shape.stable_step ? length / 4 : 0; // 0: stays where it is
            if (length > 0)
                go(u, length);
            else
                u = before_;
            next = evaluate(*problem_, data, u);
        }
        next.evaluation.step_size = length / problem_->step_unit(data);
        return next;
    }

    NonlinearProblem* problem_ = nullptr;
    double target_ = 0;
    std::optional<Gmres> gmres_;
    std::vector<double> update_, before_;
    bool begun_ = false, on_path_ = false;
    double t_ = 0, advance_ = 0;                  ///< t of the continuation; next increment of t
    int resting_ = 0, rest_ = fewest_relaxations; ///< relaxation steps left; number after the next failure
    int inner_ = 0;
    std::string note_;
};

} // namespace

std::unique_ptr<Stepper> make_newton_stepper() { return std::make_unique<NewtonStepper>(); }

} // namespace gaspard
