// Newton's method with the full linearisation of the discrete equation (nonlinear_problem.hpp), sigma
// eliminated exactly:
//
//   -(dr/dphi) dphi = r,   phi -> phi + s dphi
//
// Near a solution s = 1 is taken and convergence is quadratic. Far from it, McRae et al. found that the full
// linearisation loses convexity; so the way goes over powers of the monitor, m^t from t = 0, where the
// uniform mesh is the solution: one step for m^t, then on to a larger t, as far as steps remain good. A step
// is good if the map stays convex and solves the equation of m^t to `close`; else it is taken back, and t
// grows less.
#include "core/linear/gmres.hpp"
#include "core/method/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr double least_convexity = 0.1; ///< of that before a step; less is not taken
constexpr double close = 0.3;           ///< residual of m^t up to which a step has led to a solution for m^t
constexpr double aim = 0.1;             ///< residual of m^t that the next t is chosen for
constexpr double shortest = 1.0 / 64;   ///< part of a step that is tried
constexpr double least_advance = 1e-3;  ///< of t
constexpr double loosest = 0.1;         ///< tolerance of the linear solver
constexpr std::size_t memory = 30;      ///< of GMRES
constexpr int most_inner = 300, most_inner_far = 100; ///< near a solution, else
constexpr int shortest_rest = 8, longest_rest = 128;  ///< relaxations between two attempts

class NewtonStepper final : public Stepper {
  public:
    void begin(NonlinearProblem& problem, double target) override {
        problem_ = &problem;
        target_ = target;
        gmres_.reset(); // made when needed
        on_path_ = begun_ = false;
        resting_ = 0, rest_ = shortest_rest;
    }

    Iterate step(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                 std::stop_token stop) override {
        if (!gmres_) {
            gmres_.emplace(u.size(), memory);
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
        tell("over powers of the monitor, " + problem_->name_of_continued(advance_) + " first");
    }
    void tell(const std::string& sentence) { note_ += (note_.empty() ? "" : "; ") + sentence; }

    /// The update for the monitor for which the equation was last evaluated.
    bool solve(const ProblemData& data, double residual, std::stop_token stop) {
        problem_->linearise(data, NonlinearProblem::Linearised::fully);
        // As exact as convergence can make use of, and as the last step needs.
        const double tolerance = std::clamp(residual, std::min(loosest, 0.1 * target_ / residual), loosest);
        const bool far = residual > close; // where many iterations mean that there is a better way
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

    /// For m itself, with a step that is shortened until the residual decreases.
    Iterate directly(const ProblemData& data, std::vector<double>& u, const Iterate& now,
                     std::stop_token stop) {
        const bool solved = solve(data, now.evaluation.residual, stop);
        for (double s = 1; solved && !stop.stop_requested() && s >= shortest; s /= 2) {
            go(u, s);
            Iterate next = evaluate(*problem_, data, u);
            next.evaluation.step_size = s;
            if (next.shape.admissibility > least_convexity * now.shape.admissibility &&
                next.evaluation.residual < (1 - s / 10) * now.evaluation.residual)
                return next;
        }
        u = before_;
        Iterate same = evaluate(*problem_, data, u);
        if (stop.stop_requested()) return same;
        return give_way(data, u, same);
    }

    /// One step for m^t, with a larger t than before.
    Iterate along_path(const ProblemData& data, std::vector<double>& u, std::stop_token stop) {
        while (!stop.stop_requested()) {
            const double t = std::min(1.0, t_ + advance_);
            const ProblemData of_step = t < 1 ? problem_->continued(data, t) : data;
            const Iterate before = evaluate(*problem_, of_step, u);
            const bool solved = solve(of_step, before.evaluation.residual, stop);
            if (stop.stop_requested()) break;
            go(u, 1);
            Iterate next = evaluate(*problem_, of_step, u);
            const double residual = next.evaluation.residual;
            if (solved && residual < close &&
                next.shape.admissibility > least_convexity * before.shape.admissibility) {
                t_ = t;
                advance_ *= std::clamp(std::sqrt(aim / residual), 0.5, 3.0);
                if (t == 1) {
                    on_path_ = false;
                    tell("the monitor itself from here");
                } else {
                    next = evaluate(*problem_, data, u);
                }
                next.evaluation.step_size = 1;
                return next;
            }
            u = before_;
            advance_ = (t - t_) / 2;
            if (advance_ < least_advance) {
                tell("the path ends at " + problem_->name_of_continued(t_));
                return give_way(data, u, evaluate(*problem_, data, u));
            }
            tell(problem_->name_of_continued(t) + " is too far, " +
                 problem_->name_of_continued(t_ + advance_) + " instead");
        }
        u = before_;
        return evaluate(*problem_, data, u);
    }

    /// Where no step of Newton's is any good: some of the relaxation, which are made with the Laplacian in
    /// place of the linearisation, and directly from there.
    Iterate give_way(const ProblemData& data, std::vector<double>& u, const Iterate& now) {
        on_path_ = false;
        resting_ = rest_ - 1;
        tell("no step is any good here: " + std::to_string(rest_) + " of the relaxation");
        rest_ = std::min(2 * rest_, longest_rest);
        Iterate next = relax(data, u, now);
        next.lost = true;
        return next;
    }
    Iterate relax(const ProblemData& data, std::vector<double>& u, const Iterate& now) {
        const double length = now.shape.stable_step;
        problem_->direction(update_);
        go(u, length);
        Iterate next = evaluate(*problem_, data, u);
        next.evaluation.step_size = length;
        return next;
    }

    NonlinearProblem* problem_ = nullptr;
    double target_ = 0;
    std::optional<Gmres> gmres_;
    std::vector<double> update_, before_;
    bool begun_ = false, on_path_ = false;
    double t_ = 0, advance_ = 0; ///< the map solves the equation of m^t roughly; how much t is to grow
    int resting_ = 0, rest_ = shortest_rest; ///< relaxations to make now; at the next failure
    int inner_ = 0;
    std::string note_;
};

} // namespace

std::unique_ptr<Stepper> make_newton_stepper() { return std::make_unique<NewtonStepper>(); }

} // namespace gaspard
