// Initial vortices of flows on the doubly periodic unit square:
//
//   q(x) = sum over k of s_k exp(-|x - x_k|^2 / r^2),      distances to all images that matter
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaspard {

struct Vortex {
    std::array<double, 2> centre{}; ///< in [0, 1)^2
    double strength = 1;            ///< s: the largest q
};

/// Of alternating signs, the first positive, with strengths from 0.6 to 1; far from each other. The same
/// numbers on every machine.
std::vector<Vortex> scattered_vortices(std::size_t count, std::uint64_t seed);
/// q at n x n nodes (x fastest); 0 < radius <= 0.5.
std::vector<double> vortex_values(std::size_t n, const std::vector<Vortex>& vortices, double radius);

} // namespace gaspard
