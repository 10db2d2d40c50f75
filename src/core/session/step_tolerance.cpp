#include "core/session/step_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {
constexpr double margin = 4;    // for what changes until a step learns again
constexpr double loosest = 0.1; // residual: beyond it, iterations need not converge
}

void StepTolerance::learn(const std::vector<Sample>& samples) {
    const double before = value_;
    solved_ = samples.back().equidistribution;
    slope_ /= 2;
    for (const Sample& sample : samples)
        if (sample.residual > 10 * smallest_)
            slope_ = std::max(slope_, std::abs(sample.equidistribution - solved_) / sample.residual);
    value_ = slope_ > 0 ? (factor_ - 1) * solved_ / (margin * slope_) : loosest;
    value_ = std::clamp(value_, smallest_, std::max(loosest, smallest_));
    const bool steady = before > 0 && value_ > before / 2 && value_ < 2 * before;
    period_ = steady ? std::min(2 * period_, longest) : shortest;
    steps_ = 0;
}

void StepTolerance::check(double equidistribution) {
    if (solved_ > 0 && equidistribution > factor_ * solved_)
        period_ = std::max(shortest, period_ / 2), steps_ = period_;
}

} // namespace gaspard
