#include "core/base/error.hpp"
#include "core/fem/ellipticity.hpp"
#include "core/method/relax.hpp"
#include "core/scenario/catalogue.hpp"
#include "support/largest_distance.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace gaspard {
namespace {

const Space torus{SpaceKind::periodic_square}, walled{};

std::shared_ptr<const Monitor> off_centre_ring(Space space) {
    return make_monitor("ring", space,
                        {{"amplitude", 5}, {"sharpness", 30}, {"center_x", 0.3}, {"center_y", 0.6}});
}

class Relaxation : public testing::TestWithParam<bool> {
  protected:
    bool periodic() const { return GetParam(); }
    Space space() const { return periodic() ? torus : walled; }
    Relaxing off_centre(int cells, int steps) const {
        Relaxing run(cells, periodic(), off_centre_ring(space()), 0.1);
        while (run.iterations() < steps) run.step();
        return run;
    }
};
INSTANTIATE_TEST_SUITE_P(Boundaries, Relaxation, testing::Bool(),
                         [](const auto& run) { return run.param ? "periodic" : "walls"; });

TEST_P(Relaxation, MovesNothingForAConstantMonitor) {
    Relaxing run(17, periodic(), make_monitor("constant", space(), {{"value", 3}}), 0.1);
    for (int i = 0; i < 5; ++i) {
        EXPECT_LT(run.history.back().residual, 1e-13);
        EXPECT_NEAR(run.history.back().series[0], 3, 1e-13);
        EXPECT_LT(largest_distance(run.x(), run.plane->mesh()->nodes), 1e-13);
        run.step();
    }
}

TEST_P(Relaxation, DoesNotSeeAConstantInPhi) {
    Relaxing run = off_centre(16, 10), raised = off_centre(16, 10);
    for (double& value : raised.state.arrays[0].values) value += 0.5;
    raised.method->evaluate(problem_of(*raised.monitor), raised.state, {});
    for (int i = 0; i < 3; ++i) {
        EXPECT_LT(largest_distance(run.x(), raised.x()), 1e-13);
        const Evaluation& ours = run.step();
        const Evaluation& theirs = raised.step();
        EXPECT_NEAR(ours.residual, theirs.residual, 1e-11);
        EXPECT_NEAR(ours.series[0], theirs.series[0], 1e-11);
    }
}

TEST_P(Relaxation, KeepsTheAreaOfTheDomain) {
    const Relaxing run = off_centre(16, 30);
    const auto areas = cell_areas(*run.plane->mesh(), run.x());
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 1, 1e-14);
    EXPECT_LT(*std::min_element(areas.begin(), areas.end()), 0.5 / 256); // they did move
}

TEST_P(Relaxation, KeepsSidesTogetherOrOnTheWalls) {
    const std::size_t n = 16, side = n + 1;
    const Relaxing run = off_centre(static_cast<int>(n), 30);
    const Points& x = run.x();
    double slid = 0;
    for (std::size_t k = 0; k < side; ++k) {
        const std::size_t left = k * side, right = left + n, bottom = k, top = n * side + k;
        if (periodic()) { // one period apart
            EXPECT_NEAR(x.x[right] - x.x[left], 1, 4e-16);
            EXPECT_EQ(x.y[right], x.y[left]);
            EXPECT_NEAR(x.y[top] - x.y[bottom], 1, 4e-16);
            EXPECT_EQ(x.x[top], x.x[bottom]);
        } else { // exactly on the straight side, along which they slide
            EXPECT_EQ(x.x[left], 0);
            EXPECT_EQ(x.x[right], 1);
            EXPECT_EQ(x.y[bottom], 0);
            EXPECT_EQ(x.y[top], 1);
        }
        slid = std::max(slid, std::abs(x.y[left] - run.plane->mesh()->nodes.y[left]));
    }
    EXPECT_GT(slid, 1e-3);
}

TEST_P(Relaxation, MakesTheStepOfThePaper) {
    // (3.7) against the operators, which have slow twins of their own: phi + dt u, <grad v, grad u> = r_v.
    Relaxing run = off_centre(12, 4);
    const PlaneQ2& plane = *run.plane;
    auto workspace = plane.make_workspace();
    std::vector<double> phi = run.state.arrays[0].values, m(plane.mesh()->node_count()), r(phi.size());
    Points x;
    WeakHessian sigma;
    plane.positions(phi, x, workspace);
    EXPECT_EQ(x, run.x());
    run.monitor->values(x, m);
    plane.hessian(phi, sigma, workspace);
    const auto [theta, normalised] = plane.residual(m, sigma, r, workspace);
    EXPECT_EQ(theta, run.history.back().series[0]);
    EXPECT_EQ(normalised, run.history.back().residual);
    plane.poisson(r, r, workspace);
    const Evaluation& after = run.step();
    for (std::size_t i = 0; i < phi.size(); ++i)
        EXPECT_NEAR(run.state.arrays[0].values[i], phi[i] + 0.1 * r[i], 1e-17);
    EXPECT_EQ(after.step_size, 0.1);
    EXPECT_EQ(run.history.front().step_size, 0);
}

TEST_P(Relaxation, EvaluatesWithoutChangingTheState) {
    Relaxing run = off_centre(10, 3);
    const State before = run.state;
    const Evaluation again = run.method->evaluate(problem_of(*run.monitor), run.state, {});
    EXPECT_EQ(run.state, before);
    EXPECT_EQ(again.residual, run.history.back().residual);
    EXPECT_EQ(again.series[0], run.history.back().series[0]);
}

TEST_P(Relaxation, TakesANewStepSize) {
    Relaxing run = off_centre(10, 0), other = off_centre(10, 0);
    Values values("method", relaxation_method().rows);
    values.set("step_size", 0.05);
    run.method->configure(values);
    EXPECT_EQ(run.step().step_size, 0.05);
    other.step();
    for (std::size_t i = 0; i < run.plane->unknowns(); ++i) // from zero: half the step, half the potential
        EXPECT_DOUBLE_EQ(2 * run.state.arrays[0].values[i], other.state.arrays[0].values[i]);
}

TEST_P(Relaxation, ChoosesTheStepThatTheMapAllows) {
    Relaxing run = off_centre(16, 5);
    Values values("method", relaxation_method().rows); // auto by default
    run.method->configure(values);
    const PlaneQ2& plane = *run.plane;
    auto workspace = plane.make_workspace();
    WeakHessian sigma;
    std::vector<double> m(run.x().size());
    run.monitor->values(run.x(), m);
    plane.hessian(run.state.arrays[0].values, sigma, workspace);
    const Ellipticity e = ellipticity(plane.grid(), m, sigma);
    ASSERT_GT(e.slowest, 0);
    EXPECT_DOUBLE_EQ(run.step().step_size, 1.96 / (e.slowest + e.fastest));
    EXPECT_NE(run.step().step_size, run.history[run.history.size() - 2].step_size);
}

TEST_P(Relaxation, RecoversByItselfFromAStepThatIsTooLong) {
    Relaxing run = off_centre(24, 40);
    Values values("method", relaxation_method().rows);
    values.set("step_size", 1.0);
    run.method->configure(values);
    while (run.history.back().residual < 0.5) run.step(); // on its way out
    values.set("step_size", std::string("auto"));
    run.method->configure(values);
    run.solve();
    EXPECT_LT(run.history.back().residual, 1e-8);
    EXPECT_EQ(run.quality().tangled_cells, 0u);
}

TEST_P(Relaxation, GoesOnFromOtherMeshes) {
    const Relaxing coarse = off_centre(12, 40);
    Relaxing same = off_centre(12, 0), fine = off_centre(24, 0), finer = off_centre(31, 0);
    EXPECT_EQ(same.method->adopt(coarse.state, nullptr), coarse.state);
    for (Relaxing* run : {&fine, &finer}) {
        const auto adopted = run->method->adopt(coarse.state, nullptr);
        ASSERT_TRUE(adopted.has_value());
        EXPECT_EQ(adopted->layout, run->state.layout);
        const Evaluation there = run->method->evaluate(problem_of(*run->monitor), *adopted, {});
        EXPECT_LT(there.residual, 0.2 * run->history[0].residual); // far from the identity's
    }
    // And down again, to the very potential but for its mean.
    fine.state = *fine.method->adopt(coarse.state, nullptr);
    const auto back = same.method->adopt(fine.state, nullptr);
    ASSERT_TRUE(back.has_value());
    same.method->evaluate(problem_of(*same.monitor), *back, {});
    EXPECT_LT(largest_distance(same.x(), coarse.x()), 1e-12);
}

TEST_P(Relaxation, DoesNotTakeStatesOfAnotherKind) {
    Relaxing run = off_centre(12, 0);
    const auto refuses = [&](State state) { return !run.method->adopt(state, nullptr).has_value(); };
    State state = off_centre(16, 0).state;
    EXPECT_FALSE(refuses(state));
    State other = Relaxing(16, !periodic(), make_monitor("constant", space()), 0.1).state;
    EXPECT_TRUE(refuses(other)) << "another boundary";
    other = state, other.layout = "sphere";
    EXPECT_TRUE(refuses(other));
    other = state, other.arrays[0].name = "sigma";
    EXPECT_TRUE(refuses(other));
    other = state, other.arrays.clear();
    EXPECT_TRUE(refuses(other));
    other = state, other.arrays[0].values.pop_back();
    EXPECT_TRUE(refuses(other));
    other = run.state, other.arrays[0].values.pop_back();
    EXPECT_TRUE(refuses(other)) << "the right name on the wrong array";
    other = run.state, other.arrays[0].name = "sigma";
    EXPECT_TRUE(refuses(other));
    other = run.state, other.arrays.clear();
    EXPECT_TRUE(refuses(other));
}

TEST_P(Relaxation, ChecksThatStatesAreItsOwn) {
    Relaxing run = off_centre(12, 0);
    State other = off_centre(16, 0).state;
    EXPECT_THROW(run.method->evaluate(problem_of(*run.monitor), other, {}), InternalError);
    EXPECT_THROW(run.method->step(problem_of(*run.monitor), other, {}), InternalError);
}

class NotThePlane final : public Discretisation {
  public:
    std::shared_ptr<const Mesh> mesh() const override { return nullptr; }
    std::size_t unknowns() const override { return 0; }
};

TEST(RelaxationMethod, ChecksThatItIsOnThePlane) {
    const auto make = builtin_catalogue().capabilities.front().problem;
    EXPECT_THROW(make(std::make_shared<NotThePlane>()), InternalError);
}

// A monitor on [0,1]^2, mirrored at its walls and shrunk to half its size: periodic.
class Mirrored final : public Monitor {
  public:
    explicit Mirrored(std::shared_ptr<const Monitor> monitor) : monitor_(std::move(monitor)) {}
    void values(const Points& x, std::span<double> values) const override {
        Points folded(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) folded.set(i, {fold(2 * x.x[i]), fold(2 * x.y[i]), 0});
        monitor_->values(folded, values);
    }
    void gradients(const Points&, Points&) const override {}
    void check() const override {}

  private:
    static double fold(double t) { // into [0,1], by reflections at the whole numbers
        t -= 2 * std::floor(t / 2);
        return t <= 1 ? t : 2 - t;
    }
    std::shared_ptr<const Monitor> monitor_;
};

// The entry of a vector <v, .> on the torus of 4 n unknowns a side that belongs to node (i, j) between walls:
// half the cells' sizes, and test functions of the walls continued to the other side.
double mirrored_entry(const std::vector<double>& r, std::size_t n, std::size_t i, std::size_t j) {
    double entry = 4 * r[j * 4 * n + i];
    if (i == 0 || i == 2 * n) entry /= 2;
    if (j == 0 || j == 2 * n) entry /= 2;
    return entry;
}

TEST(Walls, AreAQuarterOfATorusOfTwiceTheSize) {
    const std::size_t n = 12;
    const auto monitor = off_centre_ring(walled);
    Relaxing walls(n, false, monitor, 0.1), whole(2 * n, true, std::make_shared<Mirrored>(monitor), 0.1);
    const auto residual = [](const Relaxing& run) {
        auto workspace = run.plane->make_workspace();
        WeakHessian sigma;
        std::vector<double> m(run.x().size()), r(run.plane->unknowns());
        run.monitor->values(run.x(), m);
        run.plane->hessian(run.state.arrays[0].values, sigma, workspace);
        run.plane->residual(m, sigma, r, workspace);
        return r;
    };
    for (int iteration = 0; iteration <= 60; ++iteration) {
        EXPECT_NEAR(walls.history.back().series[0], whole.history.back().series[0], 1e-12);
        const auto ours = residual(walls), theirs = residual(whole);
        double norm_theirs = 0, norm_weights = 0;
        for (std::size_t j = 0; j <= 2 * n; ++j)
            for (std::size_t i = 0; i <= 2 * n; ++i) {
                const double entry = mirrored_entry(theirs, n, i, j);
                ASSERT_NEAR(ours[j * (2 * n + 1) + i], entry, 1e-14) << iteration << ": " << i << ", " << j;
                const auto weight = [&](std::size_t k) {
                    return (k % 2 == 1 ? 4.0 : k == 0 || k == 2 * n ? 1.0 : 2.0) / (6.0 * n);
                };
                norm_theirs += entry * entry;
                norm_weights += std::pow(walls.history.back().series[0] * weight(i) * weight(j), 2);
            }
        EXPECT_NEAR(walls.history.back().residual, std::sqrt(norm_theirs / norm_weights), 1e-11);
        for (std::size_t j = 0; j <= n; ++j)
            for (std::size_t i = 0; i <= n; ++i) {
                const Vec3 x = walls.x()[j * (n + 1) + i], y = whole.x()[j * (2 * n + 1) + i];
                ASSERT_NEAR(norm(x - 2 * y), 0, 1e-11) << iteration << ": " << i << ", " << j;
            }
        walls.step();
        whole.step();
    }
    EXPECT_LT(walls.history.back().residual, 0.1 * walls.history.front().residual);
}

} // namespace
} // namespace gaspard
