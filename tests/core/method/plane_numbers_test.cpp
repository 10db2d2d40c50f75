// The numbers that an independent implementation found for McRae, Cotter, Budd, section 5.1.
#include "core/method/plane_numbers.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(PlaneNumbers, RingAt30) {
    Relaxing run = ring(30);
    run.solve();
    expect_numbers(run, {189, 8.818150e-2, 0.121331, 1.414023, 1.3739825391, ring_mass, 0.1437});
}

TEST(PlaneNumbers, RingAt60) {
    Relaxing run = ring(60);
    run.solve();
    expect_numbers(run, {198, 3.667985e-2, 0.121757, 1.363248, 1.3338085842, ring_mass, 0.1382});
    EXPECT_NEAR(run.history[0].residual, 0.928499, 6e-7);
    EXPECT_NEAR(run.history[1].residual, 0.760036, 6e-7);
    EXPECT_NEAR(run.history[10].residual, 0.2855043, 6e-8);
    const Vec3 vertex = run.x()[45 * 61 + 45];
    EXPECT_NEAR(vertex.x, 0.68482839, 6e-9);
    EXPECT_NEAR(vertex.y, 0.68482839, 6e-9);
}

TEST(PlaneNumbers, BellAt60) {
    Relaxing run = bell(60);
    run.solve();
    expect_numbers(run, {894, 4.754764e-2, 0.051299, 2.703835, 2.6163357561, bell_mass, 0.2249});
    EXPECT_NEAR(run.history[0].residual, 2.726859, 6e-7);
    EXPECT_NEAR(run.history[1].residual, 1.993048, 6e-7);
    EXPECT_NEAR(run.history[10].residual, 0.8912366, 6e-8);
    EXPECT_NEAR(run.iterations() / 198.0, 4.5, 0.05); // the paper's ratio of bell to ring
}

TEST(PlaneNumbers, EquidistributionAt120HasTheOrderOfThePrototype) {
    Relaxing coarse = ring(30), middle = ring(60), fine = ring(120);
    for (Relaxing* run : {&coarse, &middle, &fine}) run->solve();
    expect_numbers(fine, {212, 1.197057e-2, 0.120118, 1.320274, 1.3198122232, ring_mass, 0.1363});
    const double at_60 = middle.quality().equidistribution;
    EXPECT_NEAR(std::log2(coarse.quality().equidistribution / at_60), 1.27, 0.005);
    EXPECT_NEAR(std::log2(at_60 / fine.quality().equidistribution), 1.62, 0.005);
}

TEST(PlaneNumbers, AreOfIntegralsThatSixGaussPointsMakeRight) {
    // What quality.hpp says of its default: 3e-7 of the value at n = 30, 1e-8 from n = 60 on.
    for (const auto& [n, tolerance] : {std::pair{30, 3e-7}, {60, 1e-8}}) {
        Relaxing run = ring(n);
        run.solve();
        const double accurate =
            QualityMeter(run.plane->mesh(), 1, 16).measure(run.x(), *run.monitor).equidistribution;
        EXPECT_NEAR(run.quality().equidistribution / accurate, 1, tolerance) << n;
    }
}

} // namespace
} // namespace gaspard
