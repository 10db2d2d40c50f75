// Meshes of an interval that solve the discrete mesh PDE to rounding: with the mean density r_i of cell i by
// Simpson's rule (cell_densities),
//
//   r_i(x) (x_i - x_(i-1)) = C,   i = 1..N,   x_0 = a,   x_N = b.
//
// The iteration (15) of Hill, Madden (2021) does not get there for thin layers: where the density has a kink
// or falls by orders of magnitude within a cell, r_i changes at each step by more than the step corrects.
//
// Shooting: for a share C, nodes follow from left to right, each a root of r_i d_i = C. That takes T(C) cells
// up to b, the last of which may be a fraction; T falls with C, nearly like 1/C. C is right when T(C) = N.
// Roots are bracketed, so that kinks do not matter; one shot takes about 50 N densities.
//
// For (18) and (27), eps = 1 to 1e-12 and N = 16 to 65536, that needs at most 44 shots, 10 on average, from
// Algorithm 2 as well as from the uniform mesh, to 1e-12 and what rounding of nodes leaves. Spikes and bumps
// (widths to 1e-8) take as few, if nodes of the start are on them: others are not looked for.
#pragma once

#include "core/monitor/monitor.hpp"

#include <optional>
#include <span>
#include <vector>

namespace gaspard {

/// How far the shares r_i d_i are from equal: max |r_i d_i / C - 1| with C their mean.
double share_deviation(std::span<const double> densities, std::span<const double> x);
/// What rounding of nodes leaves of it: the largest change of a share, in units of C, when a node moves by
/// half a unit in the last place. Large where layers are far from 0 or r_i comes from a thin part of the
/// cell.
double share_rounding(const Monitor& rho, std::span<const double> densities, std::span<const double> x);

/// Shots from a mesh, one at a time. The mesh guides the search for nodes: between several roots, the
/// nearest.
class IntervalShooting {
  public:
    /// Throws InputError if x has less than two nodes or does not grow.
    explicit IntervalShooting(std::vector<double> x);

    /// The next C, and a shot. Throws InputError where rho is not positive and finite.
    void step(const Monitor& rho);

    /// The last shot's mesh, of as many cells as the first: if it took another number of cells T(C), divided
    /// evenly between its nodes. It grows, as far as numbers are dense enough.
    const std::vector<double>& mesh() const { return x_; }
    /// T(C) - N of the last shot; infinite before.
    double excess() const { return excess_; }
    /// Of mesh().
    double deviation() const { return deviation_; }
    double rounding() const { return rounding_; }
    /// Whether mesh() solves the equations as well as its numbers allow.
    bool converged(double tolerance) const { return deviation_ <= tolerance + 8 * rounding_; }
    /// No number C is left between those that took too many and too few cells: T jumps over N, as the density
    /// has features between nodes.
    bool stuck() const;

  private:
    struct End {
        double share = 0, log_cells = 0; ///< C, ln T(C)/N
    };
    double next_share() const;
    double bounds() const;

    std::vector<double> x_;
    std::vector<double> guide_, shares_; ///< the mesh of a shot that saw the whole density, its shares
    std::optional<End> many_, few_;      ///< C with T(C) > N, < N
    End last_, before_;                  ///< the last two shots
    int slow_ = 0;                       ///< shots in a row that did not halve the bounds
    double share_ = 0, most_ = 0, excess_, deviation_, rounding_ = 0;
};

struct ShootingResult {
    std::vector<double> x;
    int shots = 0;
    double deviation = 0, rounding = 0;
    bool converged = false;
};

/// Shots from the mesh `x` until they have converged, are stuck or too many. As IntervalShooting.
ShootingResult shoot_interval(const Monitor& rho, std::span<const double> x, double tolerance = 1e-12,
                              int max_shots = 60);

} // namespace gaspard
