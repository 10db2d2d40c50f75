// The node order shared by VTK and Gmsh for triangles and quadrilaterals of order 2: corners, then midpoints
// of the edges in order around the cell, then the centre of a quadrilateral.
#pragma once

#include "core/base/points.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace gaspard {

/// Checks that every midpoint node is the node of the cell that is nearest to its midpoint.
inline void expect_middle_nodes(const Points& x, const std::vector<std::size_t>& cell, std::size_t corners) {
    ASSERT_EQ(cell.size(), corners == 3 ? 6u : 9u);
    const auto nearest = [&](Vec3 p) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < cell.size(); ++k)
            if (norm(x[cell[k]] - p) < norm(x[cell[best]] - p)) best = k;
        return best;
    };
    Vec3 sum;
    for (std::size_t k = 0; k < corners; ++k) {
        const Vec3 a = x[cell[k]], b = x[cell[(k + 1) % corners]];
        EXPECT_EQ(nearest(0.5 * (a + b)), corners + k);
        sum = sum + a;
    }
    if (corners == 4) {
        EXPECT_EQ(nearest(0.25 * sum), 8u);
    }
}

} // namespace gaspard
