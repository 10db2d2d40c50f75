// How far a time step must be solved so that its equidistribution e is within a factor f of e_s, that of the
// mesh solved to method.tolerance.
//
// In some time steps the iteration goes on to method.tolerance, and every iterate on the way gives a pair of
// residual r and e. With the smallest c for which |e - e_s| <= c r holds for all of them, or half of the one
// before if that is larger, the others are solved when
//
//   r < (f - 1) e_s / (4 c)
//
// where 4 is for what changes until the next such step.
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
    /// Whether the next time step is to be solved to method.tolerance, with samples.
    bool learns() const { return steps_ >= period_; }
    /// After a step: its samples, the last of which is the mesh; none if it was not one that learns. Samples
    /// that are solved already tell nothing: the next step learns again.
    void learn(const std::vector<Sample>& samples, bool solved = true);
    /// Whether the equidistribution of a step that was measured is too large.
    bool exceeded_by(double equidistribution) const;
    void learn_next() { steps_ = period_; }
    /// The residual at which a step is solved.
    double value() const { return value_; }

  private:
    static constexpr int shortest = 8, longest = 32; ///< periods in time steps
    double factor_, smallest_;
    double value_ = 0, solved_ = 0, slope_ = 0;
    int steps_ = 0, period_ = 0;
};

} // namespace gaspard
