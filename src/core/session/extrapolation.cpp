#include "core/session/extrapolation.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

/// The largest difference of two states of one layout.
double difference(const State& a, const State& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.arrays.size(); ++k)
        for (std::size_t i = 0; i < a.arrays[k].values.size(); ++i)
            largest = std::max(largest, std::abs(a.arrays[k].values[i] - b.arrays[k].values[i]));
    return largest;
}

} // namespace

void Extrapolation::begin(double t, const State& state) {
    known_.clear();
    known_.push_front({t, state});
    best_ = 0;
}

int Extrapolation::possible(int degree) const {
    return std::min(degree, static_cast<int>(known_.size()) - 1);
}

void Extrapolation::add(double t, const State& state) {
    if (known_.empty() || known_.front().state.layout != state.layout) {
        begin(t, state);
        return;
    }
    GASPARD_CHECK(t > known_.front().t);
    double nearest = std::numeric_limits<double>::infinity();
    int best = 0;
    for (int degree = 0; degree <= possible(highest); ++degree) {
        const double away = difference(at(t, degree), state);
        if (away < nearest) nearest = away, best = degree;
    }
    // One more map than now allows a higher degree; it is tried where the highest was best.
    best_ = best == possible(highest) ? std::min(best + 1, highest) : best;
    known_.push_front({t, state});
    if (known_.size() > highest + 1) known_.pop_back();
}

State Extrapolation::at(double t, std::optional<int> degree) const {
    GASPARD_CHECK(!known_.empty());
    const int d = possible(degree.value_or(best_));
    State state = known_.front().state;
    if (d == 0) return state;
    for (auto& array : state.arrays) std::ranges::fill(array.values, 0.0);
    for (int i = 0; i <= d; ++i) {
        const Known& one = known_[static_cast<std::size_t>(i)];
        double weight = 1;
        for (int j = 0; j <= d; ++j)
            if (const double tj = known_[static_cast<std::size_t>(j)].t; j != i)
                weight *= (t - tj) / (one.t - tj);
        for (std::size_t k = 0; k < state.arrays.size(); ++k)
            for (std::size_t n = 0; n < state.arrays[k].values.size(); ++n)
                state.arrays[k].values[n] += weight * one.state.arrays[k].values[n];
    }
    return state;
}

} // namespace gaspard
