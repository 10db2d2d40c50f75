#include "core/flow/checkpoints.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gaspard {

namespace {

constexpr std::size_t most_idle = 2;

std::size_t most_states(std::size_t budget, std::size_t numbers) {
    return std::max<std::size_t>(2, budget / (std::max<std::size_t>(1, numbers) * sizeof(double)));
}

} // namespace

Checkpoints::Checkpoints(Maker make, std::vector<double> start, double interval, std::size_t budget)
    : make_(std::move(make)), interval_(interval), budget_(budget), most_(most_states(budget, start.size())) {
    GASPARD_CHECK(interval > 0 && std::isfinite(interval));
    last_ = {0, std::make_shared<const std::vector<double>>(std::move(start))};
    kept_.insert(last_);
}

std::size_t Checkpoints::bytes() const {
    const std::lock_guard lock(mutex_);
    const std::size_t states = kept_.size() + (kept_.contains(last_.first) ? 0 : 1);
    return states * last_.second->size() * sizeof(double);
}

Checkpoints::Checkpoint Checkpoints::nearest(std::int64_t k) const {
    const std::lock_guard lock(mutex_);
    const auto after = kept_.upper_bound(k);
    const Checkpoint before = *std::prev(after); // the start is always kept
    return last_.first <= k && last_.first > before.first ? last_ : before;
}

Checkpoints::State Checkpoints::keep(std::int64_t k, std::span<const double> state) const {
    const auto copy = std::make_shared<const std::vector<double>>(state.begin(), state.end());
    const std::lock_guard lock(mutex_);
    last_ = {k, copy};
    if (k % stride_ == 0) kept_.insert(last_);
    while (kept_.size() + 1 > most_ && kept_.size() > 1) { // one for the last
        stride_ *= 2;
        std::erase_if(kept_, [&](const auto& one) { return one.first % stride_ != 0; });
    }
    return copy;
}

std::unique_ptr<Evolution> Checkpoints::take() const {
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            auto evolution = std::move(idle_.back());
            idle_.pop_back();
            return evolution;
        }
    }
    return make_();
}

std::vector<double> Checkpoints::at(double t, const std::function<void(double)>& progress,
                                    const std::stop_token& stop) const {
    GASPARD_CHECK(t >= 0 && t / interval_ < 0x1p52);
    auto k = static_cast<std::int64_t>(t / interval_);
    if (time(k) > t) --k; // the quotient was rounded up
    const auto [first, state] = nearest(k);
    auto evolution = take();
    evolution->set(*state, time(first));
    for (std::int64_t i = first; i < k; ++i) {
        if (stop.stop_requested()) throw Interrupted();
        if (progress) progress(static_cast<double>(i - first) / static_cast<double>(k - first));
        evolution->advance(time(i + 1) - time(i), stop);
        evolution->set(*keep(i + 1, evolution->state()), time(i + 1)); // as if it began here
    }
    if (t > time(k)) evolution->advance(t - time(k), stop);
    std::vector<double> values = evolution->values();
    const std::lock_guard lock(mutex_);
    if (idle_.size() < most_idle) idle_.push_back(std::move(evolution));
    return values;
}

} // namespace gaspard
