// The relaxation, accelerated: Anderson's method on each mesh, and coarser meshes of the same domain for the
// first part of the way (nested iteration).
//
// A step of Anderson's is taken as long as it leaves the map convex; where it does not, a plain one of the
// length that is stable takes its place, and what was remembered is forgotten. A map that is far from a
// solution goes down to the coarsest mesh and from there up again, mesh by mesh; a map that is near, as
// when the monitor moves a little, stays where it is. On the way the State is one of the coarser mesh. An
// iteration is one update, on whatever mesh; the report is of the mesh on which it ends.
#include "core/base/check.hpp"
#include "core/method/anderson.hpp"
#include "core/method/equation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t memory = 10;      ///< differences that Anderson's method remembers
constexpr double far = 0.3;             ///< a residual from which coarser meshes are worth the way
constexpr double good_enough = 3e-2;    ///< a residual with which a coarser mesh has done its work
constexpr int coarse_iterations = 150;  ///< more are not spent on a coarser mesh
constexpr double hopeless = 100;        ///< a residual from which a coarser mesh leads nowhere
constexpr double least_convexity = 0.1; ///< of that before a step; less is not taken
constexpr double largest_growth = 10;   ///< of the residual in a step

class Accelerated final : public Method {
  public:
    Accelerated(std::unique_ptr<Equation> equation, const Values& values) {
        configure(values);
        for (; equation; equation = levels_.back()->coarser()) levels_.push_back(std::move(equation));
        select(0);
    }

    void configure(const Values& values) override {
        enough_ = std::max(good_enough, values.has("tolerance") ? values.real("tolerance") : 0.0);
    }
    void use_threads(int threads) override {
        for (auto& level : levels_) level->use_threads(threads);
    }
    double other_cpu_seconds() const override {
        double sum = 0;
        for (const auto& level : levels_) sum += level->other_cpu_seconds();
        return sum;
    }

    State initial_state() const override { return levels_[0]->initial_state(); }

    std::optional<State> adopt(const State& other) override {
        for (const auto& level : levels_) // the way up goes on from there
            if (other.layout == level->layout()) return level->adopt(other);
        return levels_[0]->adopt(other);
    }

    Evaluation evaluate(const Monitor& monitor, const State& state, std::stop_token) override {
        const auto of_state = std::find_if(levels_.begin(), levels_.end(), [&](const auto& level) {
            return level->layout() == state.layout;
        });
        GASPARD_CHECK(of_state != levels_.end());
        select(static_cast<std::size_t>(of_state - levels_.begin()));
        may_go_down_ = true;
        look(monitor, here().potential(state));
        if (level_ == 0) return now_;
        // What is said of a map is said of the mesh that was asked for, or a coarse one might end a run.
        const State fine = levels_[0]->adopt(here(), here().potential(state));
        prolonged_ = true;
        return levels_[0]->evaluate(monitor, fine.arrays[0].values);
    }

    Evaluation step(const Monitor& monitor, State& state, std::stop_token stop) override {
        here().potential(state); // checks that it is of this layout before anything is written
        if (std::exchange(may_go_down_, false) && level_ == 0 && now_.residual > far && levels_.size() > 1) {
            start_ = here().potential(state);
            go_to(levels_.size() - 1, start_, monitor, state);
        }
        const double step_size = update(monitor, here().potential(state));
        ++iterations_here_;
        const bool late = iterations_here_ >= coarse_iterations, lost = !(now_.residual < hopeless);
        const bool arrived = now_.residual < enough_ || (late && now_.residual < far);
        if (level_ > 0 && (arrived || late || lost) && !stop.stop_requested()) go_up(arrived, monitor, state);
        now_.step_size = step_size;
        return now_;
    }

    const Points& positions() override {
        if (level_ == 0) return levels_[0]->positions();
        if (!std::exchange(prolonged_, true)) {
            const State fine = levels_[0]->adopt(here(), phi_of_positions_);
            levels_[0]->move(fine.arrays[0].values);
        }
        return levels_[0]->positions();
    }

  private:
    Equation& here() { return *levels_[level_]; }

    void select(std::size_t level) {
        level_ = level;
        const std::size_t n = here().unknowns();
        anderson_.emplace(n, memory);
        direction_.resize(n);
        next_.resize(n);
        iterations_here_ = 0;
    }

    void look(const Monitor& monitor, const std::vector<double>& phi) {
        now_ = here().evaluate(monitor, phi);
        shape_ = here().ellipticity();
        prolonged_ = false;
        if (level_ > 0) phi_of_positions_ = phi;
    }

    /// To a level, with the map of a potential of the present one.
    void go_to(std::size_t level, const std::vector<double>& phi, const Monitor& monitor, State& state) {
        State there = levels_[level]->adopt(here(), phi);
        state = std::move(there); // phi may have been part of it
        select(level);
        look(monitor, here().potential(state));
    }

    /// To the next finer mesh; from the very start where this one is too coarse to have been of use.
    void go_up(bool arrived, const Monitor& monitor, State& state) {
        const std::size_t next = level_ - 1;
        if (arrived) go_to(next, here().potential(state), monitor, state);
        if (arrived && shape_.convexity > 0) {
            if (level_ > 0 && now_.residual < enough_) go_up(true, monitor, state); // nothing to do here
            return;
        }
        if (start_.empty()) start_ = levels_[0]->initial_state().arrays[0].values; // began in the middle
        select(0);
        go_to(next, start_, monitor, state);
    }

    /// One update, and the look at what came out; returns the length of its step.
    double update(const Monitor& monitor, std::vector<double>& phi) {
        const Ellipticity before = shape_;
        const double residual = now_.residual;
        const auto acceptable = [&] {
            return now_.residual < largest_growth * residual &&
                   shape_.convexity > least_convexity * before.convexity;
        };
        double length = stable_step(before);
        here().direction(direction_);
        anderson_->propose(phi, direction_, here().residual(), length, next_);
        std::swap(phi, next_); // next_ keeps the iterate from which the step is made
        look(monitor, phi);
        if (acceptable()) return length;

        // A plain one; shorter, as long as there is convexity to lose.
        const double shortest = before.convexity > 0 ? length / 16 : length;
        if (anderson_->count() == 0) length /= 2;
        anderson_->forget_differences();
        for (;; length /= 2) {
            for (std::size_t i = 0; i < phi.size(); ++i) phi[i] = next_[i] + length * direction_[i];
            look(monitor, phi);
            if (length <= shortest || acceptable()) return length;
        }
    }

    std::vector<std::unique_ptr<Equation>> levels_; ///< the first is the one that is asked for
    double enough_ = 0;
    // Where the way has come to:
    std::size_t level_ = 0;
    int iterations_here_ = 0;
    bool may_go_down_ = false;  ///< not again before somebody evaluates
    std::vector<double> start_; ///< the potential on the finest mesh from which it went down
    Evaluation now_;
    Ellipticity shape_;
    std::optional<Anderson> anderson_;
    std::vector<double> direction_, next_;
    bool prolonged_ = false;               ///< the finest mesh's positions are of a coarser one's potential,
    std::vector<double> phi_of_positions_; ///< this one
};

} // namespace

MethodType accelerated_method() {
    return {.name = "accelerated",
            .label = "Accelerated",
            .help = "Anderson acceleration of the relaxation, from coarser meshes on: no step to choose",
            .rows = {},
            .make = [](std::shared_ptr<const Discretisation> discretisation,
                       const Values& values) -> std::unique_ptr<Method> {
                return std::make_unique<Accelerated>(make_equation(std::move(discretisation)), values);
            }};
}

} // namespace gaspard
