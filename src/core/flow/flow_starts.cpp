#include "core/flow/flow_starts.hpp"

#include "core/base/check.hpp"
#include "core/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

double squared_distance(std::array<double, 2> a, std::array<double, 2> b) {
    double sum = 0;
    for (std::size_t d = 0; d < 2; ++d) {
        const double distance = std::abs(a[d] - b[d]), nearest = std::min(distance, 1 - distance);
        sum += nearest * nearest;
    }
    return sum;
}

/// exp(-((i / n - centre) / radius)^2) and all its images, for every i.
std::vector<double> bell_along(std::size_t n, double centre, double radius) {
    constexpr int reach = 4; // images farther away are below 1e-21 for radius <= 0.5
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i)
        for (int image = -reach; image <= reach; ++image) {
            const double z = (static_cast<double>(i) / static_cast<double>(n) - centre + image) / radius;
            values[i] += std::exp(-z * z);
        }
    return values;
}

} // namespace

std::vector<Vortex> scattered_vortices(std::size_t count, std::uint64_t seed) {
    constexpr int candidates = 30; // of which the one that is farthest from the others is taken
    std::mt19937_64 random(seed);
    std::vector<Vortex> vortices;
    for (std::size_t k = 0; k < count; ++k) {
        Vortex next;
        double farthest = -1;
        for (int trial = 0; trial < candidates; ++trial) {
            const double x = uniform(random), y = uniform(random);
            double distance = std::numeric_limits<double>::max();
            for (const Vortex& one : vortices)
                distance = std::min(distance, squared_distance(one.centre, {x, y}));
            if (distance > farthest) farthest = distance, next.centre = {x, y};
        }
        next.strength = (k % 2 == 0 ? 1 : -1) * (0.6 + 0.4 * uniform(random));
        vortices.push_back(next);
    }
    return vortices;
}

std::vector<double> vortex_values(std::size_t n, const std::vector<Vortex>& vortices, double radius) {
    GASPARD_CHECK(radius > 0 && radius <= 0.5);
    std::vector<double> q(n * n);
    for (const Vortex& vortex : vortices) {
        const auto x = bell_along(n, vortex.centre[0], radius), y = bell_along(n, vortex.centre[1], radius);
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < n; ++i) q[j * n + i] += vortex.strength * x[i] * y[j];
    }
    return q;
}

} // namespace gaspard
