// Communication between the solver thread and its owner: a bounded lossless queue, and a holder of the latest
// value.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <stop_token>
#include <utility>
#include <vector>

namespace gaspard {

/// A first-in, first-out queue of at most `capacity` values. Nothing is dropped: writers wait while it is
/// full.
template <class T>
class Channel {
  public:
    explicit Channel(std::size_t capacity) : capacity_(capacity) {}

    /// Waits until the queue is not full. Returns false, without adding the value, if asked to stop while
    /// waiting.
    bool push(T value, std::stop_token stop) {
        std::unique_lock lock(mutex_);
        if (!not_full_.wait(lock, stop, [&] { return values_.size() < capacity_; })) return false;
        values_.push_back(std::move(value));
        return true;
    }

    /// Removes and returns all values, without waiting.
    std::vector<T> drain() {
        std::deque<T> taken;
        {
            std::lock_guard lock(mutex_);
            taken.swap(values_);
        }
        not_full_.notify_all();
        return {std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end())};
    }

  private:
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable_any not_full_;
    std::deque<T> values_;
};

/// Holds only the latest value.
template <class T>
class Latest {
  public:
    void put(std::shared_ptr<const T> value) {
        std::lock_guard lock(mutex_);
        value_.swap(value); // destroys the old value after releasing the lock
    }
    std::shared_ptr<const T> get() const {
        std::lock_guard lock(mutex_);
        return value_;
    }

  private:
    mutable std::mutex mutex_;
    std::shared_ptr<const T> value_;
};

} // namespace gaspard
