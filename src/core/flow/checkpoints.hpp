// A computation in time of which any time can be asked for, in any order: its states s_k at multiples of an
// interval D are kept as checkpoints, from which it goes on,
//
//   s_{k+1} = advance(s_k, D),      s(t) = advance(s_k, t - k D),   k = floor(t / D)
//
// Every state is computed by this rule, so that s(t) has the same bits whatever was asked for before, and
// however many checkpoints there is memory for. When they do not fit any more, those at odd multiples of a
// stride go and the stride doubles: to go back takes at most `stride` intervals again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace gaspard {

/// A computation that can go on from any of its states. What it does depends on the state and its time alone.
class Evolution {
  public:
    virtual ~Evolution() = default;
    virtual void set(std::span<const double> state, double time) = 0;
    /// By exactly this time, 0 or more. Throws Interrupted if asked to stop, InputError if it cannot go on.
    virtual void advance(double duration, const std::stop_token& stop) = 0;
    virtual std::span<const double> state() const = 0;
    /// What is asked for, such as values at nodes; of the present state.
    virtual std::vector<double> values() = 0;
};

/// May be used from several threads at once; no lock is held while it computes.
class Checkpoints {
  public:
    using Maker = std::function<std::unique_ptr<Evolution>()>;
    /// From `start` at time 0; `interval` > 0. `budget`: bytes for states, of which there are always the
    /// start and the last checkpoint.
    Checkpoints(Maker make, std::vector<double> start, double interval, std::size_t budget);

    double interval() const { return interval_; }
    std::size_t budget() const { return budget_; }
    /// Of the states that are kept.
    std::size_t bytes() const;

    /// Evolution::values at a time t >= 0. Reports the fraction of the intervals that are done. Throws what
    /// Evolution::advance does.
    std::vector<double> at(double t, const std::function<void(double)>& progress = {},
                           const std::stop_token& stop = {}) const;

  private:
    using State = std::shared_ptr<const std::vector<double>>;
    using Checkpoint = std::pair<std::int64_t, State>; ///< k and s_k

    Checkpoint nearest(std::int64_t k) const;
    State keep(std::int64_t k, std::span<const double> state) const;
    std::unique_ptr<Evolution> take() const;
    double time(std::int64_t k) const { return static_cast<double>(k) * interval_; }

    Maker make_;
    double interval_;
    std::size_t budget_, most_; ///< most_: states
    mutable std::mutex mutex_;  ///< of the following, which are a cache
    mutable std::map<std::int64_t, State> kept_;
    mutable std::int64_t stride_ = 1;
    mutable Checkpoint last_;                              ///< that was computed
    mutable std::vector<std::unique_ptr<Evolution>> idle_; ///< to be used again
};

} // namespace gaspard
