// Crossing bands under refinement, as in figures 12 and 13 of McRae, Cotter, Budd: no cell tangles, the
// number of iterations stays, and the equidistribution measure falls with the cell width.
#include "core/method/relax_sphere.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(SphereNumbersLong, CrossUnderRefinementIsOfFirstOrder) {
    double last = 0;
    for (const int refinements : {3, 4, 5}) {
        OnSurface run(sphere_setup({SphereCells::icosahedral, refinements}), on_sphere("cross"), 0.1);
        run.solve();
        EXPECT_NEAR(run.iterations(), 130, 5);
        const MeshQuality quality = run.quality();
        EXPECT_EQ(quality.tangled_cells, 0u);
        if (refinements == 5) { // 1.24 from 3 to 4, 1.01 from 5 to 6
            EXPECT_NEAR(std::log2(last / quality.equidistribution), 1, 0.06);
        }
        last = quality.equidistribution;
    }
}

} // namespace
} // namespace gaspard
