// Values at the points of one axis, from values at other points a_0 < a_1 < ...: the cubic spline through
// them, twice continuously differentiable, with end slopes of the cubics through the four outermost points;
// error O(h^4). It is kept between the values at both ends of an interval unless the data are smooth there:
// their second differences around it, four unless the axis ends, have one sign and differ by less than a
// factor of 3. Even then it does not go below half of the smaller one of two positive values (likewise for
// negative ones), so that what is positive stays so. Where the wanted points are further apart than the given
// ones, averages over their steps.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gaspard {

/// Along one direction of a grid, in its coordinates.
class LineResampling {
  public:
    /// `axis` increases strictly; `first`, `step`, `count`: the wanted points. With a period the axis stands
    /// for all its images; unless it goes around, points beside its ends get the value of the nearer end, as
    /// they do without a period.
    LineResampling(std::vector<double> axis, double first, double step, std::size_t count,
                   std::optional<double> period);

    /// `given`: axis.size() values. Overwrites `wanted`, count values.
    void apply(std::span<const double> given, std::span<double> wanted) const;
    /// Whether a wanted point lies within the axis, or at most half a step of the axis beside its ends.
    bool covers(std::size_t i) const { return covered_[i]; }

  private:
    struct Sample {
        std::size_t interval = 0;
        double fraction = 0; ///< 0 to 1
    };
    void prepare_slopes();
    void go_around(double period);
    Sample sample(double at, std::optional<double> period);

    std::vector<double> axis_;            ///< with images beside its ends if it goes around
    std::vector<std::size_t> sources_;    ///< of each entry the index of the given value
    std::vector<double> upper_, inverse_; ///< the factorised matrix of the slopes
    std::vector<Sample> samples_;         ///< `average_` of each wanted point
    std::size_t average_ = 1;
    std::vector<char> covered_;
};

} // namespace gaspard
