// Options, diagnostics and initial states of flows on the doubly periodic unit square. Lengths are in sides
// of the square, times in units of the equations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gaspard {

struct FlowOptions {
    std::size_t cells = 100;            ///< n squares per side, 3 to 4096
    double froude = 1;                  ///< Fr >= 0; with 0 psi has mean zero, and so must q
    std::array<double, 2> background{}; ///< U
    /// dt times the largest rate at which a triangle is emptied (outflow / area), in (0, 0.5]. Steps are
    /// stable up to 0.54 in every direction of flow (docs/flow.md).
    double courant = 0.4;
    std::size_t most_steps = 10'000'000; ///< of one call of advance
};

struct FlowDiagnostics {
    double mean = 0;          ///< of q
    double low = 0, high = 0; ///< bounds of q
    double energy = 0;        ///< 1/2 integral of |grad psi|^2 + Fr psi^2
    double enstrophy = 0;     ///< 1/2 integral of q^2
};

/// Values at n x n nodes (x fastest), uniform in [-1, 1): the same numbers on every machine.
std::vector<double> noise_values(std::size_t n, std::uint64_t seed);
/// Values of a function of x and y at the nodes (i / n, j / n).
std::vector<double> nodal_values(std::size_t n, const std::function<double(double, double)>& f);
/// The continuous function with these values at n x n nodes, as a state of QuasiGeostrophicFlow.
std::vector<double> continuous_state(std::size_t n, std::span<const double> nodal);

} // namespace gaspard
