// The numbers that an independent implementation found for McRae, Cotter, Budd, section 5.2, by relaxation.
#include "core/method/relax_sphere.hpp"
#include "support/periodic_surface.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

struct Expected {
    int iterations;
    double equidistribution, vertices, nodes, theta;
};

/// To a unit of the last of six digits; (5.9) and theta to those that are given.
void expect_numbers(const OnSurface& run, const Expected& expected) {
    EXPECT_EQ(run.iterations(), expected.iterations);
    const MeshQuality quality = run.quality();
    EXPECT_NEAR(quality.equidistribution / expected.equidistribution, 1, 8e-6);
    EXPECT_EQ(quality.tangled_cells, 0u);
    EXPECT_NEAR(run.deviation().vertices / expected.vertices, 1, 5e-5);
    EXPECT_NEAR(run.deviation().nodes / expected.nodes, 1, 5e-5);
    EXPECT_NEAR(run.history.back().series[0], expected.theta, 6e-10);
}

TEST(SphereNumbers, X2) {
    OnSurface run(sphere_setup({SphereCells::cubed, 16}), on_sphere("x-n"), 2.0);
    run.solve();
    expect_numbers(run, {32, 2.84024e-3, 4.42004e-4, 3.50737e-4, .313702350});
    EXPECT_NEAR(ExactMap::of(*run.monitor)->theta(), .313702927, 6e-10);
}

TEST(SphereNumbers, X4) {
    OnSurface run(sphere_setup({SphereCells::cubed, 16}), on_sphere("x-n", {{"ratio", 4}}), 2.0);
    run.solve();
    expect_numbers(run, {132, 6.10475e-3, 1.03649e-3, 8.14601e-4, .151767299});
}

TEST(SphereNumbers, X8) {
    OnSurface run(sphere_setup({SphereCells::cubed, 16}), on_sphere("x-n", {{"ratio", 8}}), 2.0);
    run.solve();
    expect_numbers(run, {302, 9.30283e-3, 1.96451e-3, 1.49425e-3, .114786198});
}

TEST(SphereNumbers, X16) {
    OnSurface run(sphere_setup({SphereCells::cubed, 16}), on_sphere("x-n", {{"ratio", 16}}), 2.0);
    run.solve();
    expect_numbers(run, {552, 1.25344e-2, 3.61757e-3, 2.60863e-3, .106590744});
}

TEST(SphereNumbers, X2WithTheMonitorAtVerticesOnly) {
    OnSurface run(sphere_setup({SphereCells::cubed, 16}, 2, 1, true), on_sphere("x-n"), 2.0);
    run.solve();
    EXPECT_EQ(run.iterations(), 31);
    EXPECT_NEAR(run.quality().equidistribution, 3.665e-3, 6e-7);
    EXPECT_NEAR(run.deviation().vertices, 9.78e-4, 6e-7);
}

TEST(SphereNumbers, X2OfBilinearFacets) {
    OnSurface run(sphere_setup({SphereCells::cubed, 16}, 1), on_sphere("x-n"), 2.0);
    run.solve();
    EXPECT_EQ(run.iterations(), 32);
    EXPECT_NEAR(run.quality().equidistribution, 4.580e-3, 6e-7);
    EXPECT_NEAR(run.deviation().vertices, 1.252e-3, 6e-7);
}

TEST(SphereNumbers, X4AndX16OfBilinearFacetsBlowUp) {
    for (const auto& [ratio, iterations] : {std::pair{4.0, 25}, {16.0, 15}}) {
        OnSurface run(sphere_setup({SphereCells::cubed, 16}, 1), on_sphere("x-n", {{"ratio", ratio}}), 2.0);
        while (run.iterations() < iterations - 8) run.step();
        EXPECT_LT(run.history.back().residual, 1);
        while (run.iterations() < iterations) run.step();
        EXPECT_GT(run.history.back().residual, 10); // a hundred times that of eight iterations before
        EXPECT_GT(run.quality().tangled_cells, 100u);
    }
}

TEST(SphereNumbers, EquiangularNodesAndOtherLongitudesChangeX16ALittle) {
    OnSurface equiangular(sphere_setup({SphereCells::cubed, 16, MidNodes::equiangular}),
                          on_sphere("x-n", {{"ratio", 16}}), 2.0);
    equiangular.solve();
    EXPECT_NEAR(equiangular.quality().equidistribution, 1.339e-2, 6e-6);
    EXPECT_NEAR(equiangular.deviation().vertices, 3.54e-3, 6e-6);
    OnSurface turned(sphere_setup({SphereCells::cubed, 16}),
                     on_sphere("x-n", {{"ratio", 16}, {"center_longitude", 20}}), 2.0);
    turned.solve();
    EXPECT_EQ(turned.iterations(), 559);
    EXPECT_NEAR(turned.quality().equidistribution, 1.162e-2, 6e-6);
    EXPECT_NEAR(turned.deviation().vertices, 3.455e-3, 6e-7);
}

TEST(SphereNumbers, CrossOnTheIcosahedron) {
    OnSurface run(sphere_setup({SphereCells::icosahedral, 4}), on_sphere("cross"), 0.1);
    run.solve();
    EXPECT_EQ(run.iterations(), 130);
    EXPECT_NEAR(run.quality().equidistribution, 5.1899e-2, 6e-7);
    EXPECT_EQ(run.quality().tangled_cells, 0u);
    // Areas against those of the same cells before: by the monitor that is 1.
    QualityMeter meter(run.surface->mesh(), 1, 6, {SpaceKind::sphere});
    const auto areas = meter.measure(run.x(), *on_sphere("constant")).cell_mass;
    EXPECT_NEAR(*std::min_element(areas.begin(), areas.end()), .10732, 6e-6);
    EXPECT_NEAR(*std::max_element(areas.begin(), areas.end()), 2.34451, 6e-6);
}

TEST(FlatSurface, OfSquaresMakesTheMeshesOfThePlane) {
    // Degree 8 by 5 x 5 points and exact integrals by 4 x 4 are the same there.
    OnSurface run(periodic_surface(30, CellShape::quadrilateral),
                  make_monitor("ring", {SpaceKind::periodic_square}), 0.1);
    run.solve();
    EXPECT_EQ(run.iterations(), 189);
    EXPECT_NEAR(run.history.back().series[0], 1.3739825391, 6e-11);
    QualityMeter meter(run.surface->mesh());
    EXPECT_NEAR(meter.measure(run.x(), *run.monitor).equidistribution, 8.818150e-2, 6e-8);
}

} // namespace
} // namespace gaspard
