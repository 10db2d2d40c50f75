// What is expected of a mesh that the relaxation method has finished, to all digits known.
#pragma once

#include "core/method/convexity.hpp"
#include "core/method/relax.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace gaspard {

struct Expected {
    int iterations;
    double equidistribution, smallest_area, largest_area, theta, mean_mass, eigenvalue;
};

inline void expect_numbers(const Relaxing& run, const Expected& expected) {
    EXPECT_EQ(run.iterations(), expected.iterations);
    EXPECT_NEAR(run.history.back().series[0], expected.theta, 6e-11);
    const MeshQuality quality = QualityMeter(run.plane->mesh(), 1, 10).measure(run.x(), *run.monitor);
    const double digit =
        std::pow(10, std::floor(std::log10(expected.equidistribution)) - 6); // the last given
    EXPECT_NEAR(quality.equidistribution, expected.equidistribution, 0.6 * digit);
    EXPECT_EQ(quality.tangled_cells, 0u);
    const double mean = std::accumulate(quality.cell_mass.begin(), quality.cell_mass.end(), 0.0) /
                        static_cast<double>(quality.cell_mass.size());
    EXPECT_NEAR(mean, expected.mean_mass, 1e-6);
    const auto areas = cell_areas(*run.plane->mesh(), run.x());
    const double unit = run.plane->grid().h() * run.plane->grid().h();
    EXPECT_NEAR(*std::min_element(areas.begin(), areas.end()) / unit, expected.smallest_area, 6e-7);
    EXPECT_NEAR(*std::max_element(areas.begin(), areas.end()) / unit, expected.largest_area, 6e-7);
    EXPECT_NEAR(smallest_eigenvalue(*run.plane, run.state.arrays[0].values), expected.eigenvalue, 6e-5);
}

/// The mean of the M_i: the integral of the monitor.
inline const double ring_mass = 1 + std::numbers::pi / 10, bell_mass = 1 + std::numbers::pi / 2;

} // namespace gaspard
