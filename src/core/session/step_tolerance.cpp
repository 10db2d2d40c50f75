#include "core/session/step_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {
constexpr double margin = 4;    // for what changes until a step learns again
constexpr double loosest = 0.1; // residual: beyond it, iterations need not converge
} // namespace

void StepTolerance::learn(const std::vector<Sample>& samples, bool solved) {
    ++steps_;
    if (samples.empty()) return;
    const double before = value_;
    const double nearest = samples.back().equidistribution;
    double slope = 0, farthest = 0; // of the samples that tell something
    for (const Sample& sample : samples)
        if (sample.residual > 10 * smallest_) {
            farthest = std::max(farthest, sample.residual);
            slope = std::max(slope, std::abs(sample.equidistribution - nearest) / sample.residual);
        }
    if (!solved || farthest == 0) {
        value_ = std::max(value_, smallest_);
        period_ = solved ? 0 : shortest;
        steps_ = 0;
        return;
    }
    solved_ = nearest;
    slope_ = std::max(slope, slope_ / 2);
    value_ = slope_ > 0 ? (factor_ - 1) * solved_ / (margin * slope_) : loosest;
    // Not far beyond what was seen.
    value_ = std::clamp(value_, smallest_, std::max(smallest_, std::min(loosest, 10 * farthest)));
    const bool steady = before > 0 && value_ > before / 2 && value_ < 2 * before;
    period_ = steady ? std::clamp(2 * period_, shortest, longest) : shortest;
    steps_ = 0;
}

bool StepTolerance::exceeded_by(double equidistribution) const {
    return solved_ > 0 && equidistribution > factor_ * solved_;
}

} // namespace gaspard
