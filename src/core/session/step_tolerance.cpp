#include "core/session/step_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {
constexpr double margin = 4;    // for what changes until a step learns again
constexpr double farther = 30;  // than it must, a step that learns is solved
constexpr double loosest = 0.1; // residual: beyond it, iterations need not converge
} // namespace

double StepTolerance::aim_to_learn() const {
    return known_ ? std::max(smallest_, value_ / farther) : smallest_;
}

void StepTolerance::learn(const std::vector<Sample>& samples, bool solved) {
    ++steps_;
    if (samples.empty()) return;
    steps_ = 0;
    const double nearest = samples.back().equidistribution;
    const double least = 10 * std::max(smallest_, samples.back().residual); // below it, e is e_s
    double slope = 0, farthest = 0;
    for (const Sample& sample : samples)
        if (sample.residual > least) {
            farthest = std::max(farthest, sample.residual);
            slope = std::max(slope, std::abs(sample.equidistribution - nearest) / sample.residual);
        }
    if (solved) solved_ = nearest;
    if (!solved || farthest == 0) {
        value_ = std::max(value_, smallest_);
        period_ = solved && !known_ ? 0 : shortest;
        return;
    }
    const double before = value_;
    slope_ = std::max(slope, slope_ / 2);
    value_ = slope_ > 0 ? (factor_ - 1) * solved_ / (margin * slope_) : loosest;
    // Not far beyond what was seen.
    value_ = std::clamp(value_, smallest_, std::max(smallest_, std::min(loosest, 10 * farthest)));
    const bool steady = known_ && value_ > before / 2 && value_ < 2 * before;
    period_ = steady ? std::clamp(2 * period_, shortest, longest) : shortest;
    known_ = true;
}

bool StepTolerance::exceeded_by(double equidistribution) const {
    return solved_ > 0 && equidistribution > factor_ * solved_;
}

} // namespace gaspard
