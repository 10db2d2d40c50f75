// Moving least squares: at x the constant a and the slope g that minimise
//
//   sum over i of w_i ( a + g . (p_i - x) - v_i )^2,      w_i = exp(-4 (d_i / D)^2) - exp(-4),   d_i = |p_i -
// x|,
//
// over the `neighbours` nearest points p_i, D the distance of the furthest; u(x) = a, within the range of
// these v_i. Linear functions are reproduced. The slope is damped by a little, so that points on a line or a
// surface determine it.
#pragma once

#include "core/base/points.hpp"

#include <memory>
#include <vector>

namespace gaspard {

class ScatteredFit {
  public:
    /// `dimension`: 2 (z is 0) or 3. At least one point; as many values.
    ScatteredFit(Points points, std::vector<double> values, int dimension);
    ~ScatteredFit();
    ScatteredFit(ScatteredFit&&) noexcept;

    struct Value {
        double value, distance; ///< distance: to the nearest point
    };
    Value at(Vec3 x) const;
    /// The typical distance between neighbouring points, as in a square grid as dense.
    double spacing() const;

    static constexpr std::size_t neighbours = 12;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

} // namespace gaspard
