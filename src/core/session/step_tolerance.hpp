// How far a time step must be solved so that its equidistribution e is within a factor f of e_s, that of the
// mesh solved to method.tolerance.
//
// In some time steps the iteration goes on much farther than it must, and every iterate on the way gives a
// pair of residual r and e. With e_s from the last of them, and the smallest c for which |e - e_s| <= c r
// holds for all, or half of the one before if that is larger, the other steps are solved when
//
//   r < (f - 1) e_s / (4 c) = r_0
//
// where 4 is for what changes until the next such step. The first goes on to method.tolerance, those after it
// to r_0 / 30, where e differs from e_s by less than (f - 1) e_s / 120.
#pragma once

#include <vector>

namespace gaspard {

class StepTolerance {
  public:
    struct Sample {
        double residual = 0, equidistribution = 0;
    };

    /// `smallest`: method.tolerance.
    StepTolerance(double factor, double smallest) : factor_(factor), smallest_(smallest) {}
    /// Whether the next time step is to be solved farther than it must, with samples.
    bool learns() const { return steps_ >= period_; }
    /// The residual at which the next time step is solved.
    double aim() const { return learns() ? aim_to_learn() : value_; }
    /// After a step: its samples, the last of which is the mesh; none if it was not one that learns. If all
    /// are about as small as the last, they tell nothing, and what was known stays.
    void learn(const std::vector<Sample>& samples, bool solved = true);
    /// Whether the equidistribution of a step that was measured is too large.
    bool exceeded_by(double equidistribution) const;
    /// The next step learns, from method.tolerance.
    void learn_anew() { steps_ = period_, known_ = false; }
    /// The residual at which a step is solved that does not learn.
    double value() const { return value_; }

  private:
    double aim_to_learn() const;

    static constexpr int shortest = 8, longest = 32; ///< periods in time steps
    double factor_, smallest_;
    double value_ = 0, solved_ = 0, slope_ = 0;
    int steps_ = 0, period_ = 0;
    bool known_ = false; ///< value_ comes from samples
};

} // namespace gaspard
