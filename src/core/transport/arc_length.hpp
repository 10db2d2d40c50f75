// The length of a curve from its start as its parameter.
#pragma once

#include <functional>
#include <vector>

namespace gaspard {

/// s(u) = integral of the speed from the first break to u, by Gauss's rule on intervals that are halved until
/// the length is exact to rounding; the inverse by Newton's method.
class ArcLength {
  public:
    /// speed(u) = |d gamma / du|, smooth between ascending breaks and positive but at some of them.
    ArcLength(std::function<double(double)> speed, const std::vector<double>& breaks);

    double total() const { return lengths_.back(); }
    /// u(s) for s in [0, total()].
    double parameter(double length) const;

  private:
    void add(double low, double high, double whole, double accepted, int depth);
    double integral(double low, double high) const;

    std::function<double(double)> speed_;
    std::vector<double> knots_, lengths_; ///< ends of the intervals, and s there
};

} // namespace gaspard
