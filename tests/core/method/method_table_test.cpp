// A part of the table in docs/newton.md: what each method needs for monitors from easy to harsh.
#include "core/method/driven.hpp"
#include "core/method/relax_sphere.hpp"

#include <algorithm>

namespace gaspard {
namespace {

struct Case {
    std::string monitor;
    Settings values;
    std::size_t tangled; ///< what this mesh cannot carry
    // Iterations at most; 0: not tried.
    int accelerated, newton, automatic;
};

const std::vector<Case> cases = {
    {"ring", {}, 0, 50, 12, 24},
    {"bell", {}, 0, 90, 18, 42},
    {"bell", {{"amplitude", 500}}, 0, 0, 28, 92},
    {"bell", {{"amplitude", 5000}}, 0, 0, 32, 225},
    {"ring", {{"amplitude", 200}}, 8, 0, 32, 80},
    {"random-bells", {{"seed", 1}}, 0, 90, 16, 34},
    {"ring-and-bell", {{"bell_center_x", 0.2}, {"bell_center_y", 0.3}}, 0, 115, 18, 42},
};

void expect_kept(const MethodType& type, int Case::*most) {
    for (const Case& c : cases) {
        if (c.*most == 0) continue;
        SCOPED_TRACE(c.monitor + " " + (c.values.empty() ? "" : std::to_string(c.values[0].second)));
        Driven run(type, 30, true);
        run.begin(monitor_of(c.monitor, true, c.values));
        EXPECT_LE(run.solve(), c.*most);
        EXPECT_EQ(run.quality().tangled_cells, c.tangled);
    }
}

TEST(MethodTable, IsKeptByAccelerated) { expect_kept(accelerated_method(), &Case::accelerated); }
TEST(MethodTable, IsKeptByNewton) { expect_kept(newton_method(), &Case::newton); }
TEST(MethodTable, IsKeptByAuto) { expect_kept(automatic_method(), &Case::automatic); }

TEST(MethodTable, NewtonSolvesX16InTwentyIterationsWithAQuadraticEnd) {
    OnSurface run(sphere_setup({SphereCells::cubed, 16}), on_sphere("x-n", {{"ratio", 16}}), 1, "newton");
    run.solve();
    EXPECT_LE(run.iterations(), 20);
    EXPECT_EQ(run.quality().tangled_cells, 0u);
    // To a tenth of the tolerance, below which the linear solver does not go.
    for (std::size_t k = run.history.size() - 3; k < run.history.size(); ++k) {
        const double before = run.history[k - 1].residual;
        EXPECT_EQ(run.history[k].step_size, 1);
        EXPECT_LT(run.history[k].residual, std::max(20 * before * before, 1e-9)) << k;
    }
}

} // namespace
} // namespace gaspard
