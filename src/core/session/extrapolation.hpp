// Where the map of the next time step is expected: the polynomial in time through the last ones,
//
//   s(t) = sum_i s_i prod_{j != i} (t - t_j) / (t_i - t_j)        of degree 0, 1 or 2
//
// The unknowns of methods are coefficients of maps or potentials, so that such sums are maps again.
#pragma once

#include "core/method/method.hpp"

#include <deque>
#include <optional>

namespace gaspard {

class Extrapolation {
  public:
    static constexpr int highest = 2; ///< degree

    /// Forgets all maps but adds this one.
    void begin(double t, const State& state);
    /// The map of a later time. One of another layout begins anew.
    void add(double t, const State& state);
    /// At a later time, with this degree or what the known maps allow; nullopt: with the degree that would
    /// have been nearest to the map added last. At least one map must be known.
    State at(double t, std::optional<int> degree) const;
    /// The degree that would have been best.
    int best() const { return best_; }

  private:
    struct Known {
        double t;
        State state;
    };
    int possible(int degree) const;

    std::deque<Known> known_; ///< newest first, at most highest + 1
    int best_ = 0;
};

} // namespace gaspard
