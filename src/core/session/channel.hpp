// What passes between the solver thread and its owner: a bounded lossless queue, and a newest-wins mailbox.
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

/// A first-in, first-out queue of at most `capacity` values. Nothing is dropped: a full queue holds its
/// writer back.
template <class T>
class Channel {
  public:
    explicit Channel(std::size_t capacity) : capacity_(capacity) {}

    /// Waits for room; false (and the value is not taken) when asked to stop meanwhile.
    bool push(T value, std::stop_token stop) {
        std::unique_lock lock(mutex_);
        if (!workspace_.wait(lock, stop, [&] { return values_.size() < capacity_; })) return false;
        values_.push_back(std::move(value));
        return true;
    }

    /// Everything there is, without waiting.
    std::vector<T> drain() {
        std::deque<T> taken;
        {
            std::lock_guard lock(mutex_);
            taken.swap(values_);
        }
        workspace_.notify_all();
        return {std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end())};
    }

  private:
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable_any workspace_;
    std::deque<T> values_;
};

/// Holds the newest value only.
template <class T>
class Latest {
  public:
    void put(std::shared_ptr<const T> value) {
        std::lock_guard lock(mutex_);
        value_.swap(value); // the old value is released after the lock
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
