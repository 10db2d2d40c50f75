// Whole solves of the table in docs/newton.md on which methods once failed or wasted their time.
#include "core/method/driven.hpp"

namespace gaspard {
namespace {

// The accelerated relaxation made plain steps here for ever: each of Anderson's was too long.
TEST(MethodTable, AcceleratedGetsOutOfPlainSteps) {
    Driven run(accelerated_method(), 120, true);
    run.begin(monitor_of("bell", true, {{"amplitude", 500}}));
    EXPECT_LE(run.solve(), 600);
    EXPECT_EQ(run.quality().tangled_cells, 0u);
}

// Its map from n = 60 is not convex everywhere at n = 120, and good nevertheless.
TEST(MethodTable, AutomaticGoesUpWithAMapThatIsAlmostConvex) {
    Driven run(automatic_method(), 120, true);
    run.begin(monitor_of("random-bells", true, {{"seed", 1}}));
    EXPECT_LE(run.solve(), 60);
    EXPECT_EQ(run.quality().tangled_cells, 0u);
}

} // namespace
} // namespace gaspard
