// The finest mesh of the independent implementation for McRae, Cotter, Budd, section 5.4.
#include "core/method/plane_numbers.hpp"

namespace gaspard {
namespace {

TEST(LongPlaneNumbers, RingAt240) {
    Relaxing coarse = ring(120), fine = ring(240);
    coarse.solve();
    fine.solve();
    expect_numbers(fine, {221, 3.387995e-3, 0.119638, 1.315732, 1.3156545392, ring_mass, 0.1358});
    const double order = std::log2(coarse.quality().equidistribution / fine.quality().equidistribution);
    EXPECT_NEAR(order, 1.82, 0.005); // towards 2
}

TEST(LongPlaneNumbers, ConstantMonitorMovesNothingOnTheLargestMesh) {
    for (const bool periodic : {true, false}) {
        Relaxing run(480, periodic, make_monitor("constant", {}, {{"value", 7}}), 0.1);
        for (int i = 0; i < 3; ++i) run.step();
        const Points& xi = run.plane->mesh()->nodes;
        for (std::size_t i = 0; i < xi.size(); ++i) ASSERT_LT(norm(run.x()[i] - xi[i]), 1e-13);
        EXPECT_LT(run.history.back().residual, 1e-11);
    }
}

} // namespace
} // namespace gaspard
