// A pool of threads that wait for work, so that short loops can be shared without starting threads each time.
#pragma once

#include "core/base/stopwatch.hpp"

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace gaspard {

/// The constructing thread is the first worker. Calls must come from one thread at a time.
class Team {
  public:
    explicit Team(std::size_t workers = 1);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    std::size_t workers() const { return 1 + others_.size(); }
    /// Splits 0 .. count into one range per worker and calls work(worker, begin, end) for each, even if the
    /// range is empty. Rethrows the first exception after all workers have finished.
    template <class Work>
    void share(std::size_t count, const Work& work) {
        if (others_.empty()) return work(std::size_t{0}, std::size_t{0}, count);
        const std::size_t all = workers();
        call_all(
            [&, all](std::size_t worker) { work(worker, count * worker / all, count * (worker + 1) / all); });
    }
    /// Total CPU time of the other workers, which the caller's thread clock does not include.
    double other_cpu_seconds() const;

  private:
    struct Other {
        std::jthread thread;
        std::exception_ptr error;
        double cpu_seconds = 0;
    };
    void call_all(const std::function<void(std::size_t)>& work);
    void work_until_stopped(std::size_t worker);

    const std::function<void(std::size_t)>* work_ = nullptr; ///< null: the workers end
    std::atomic<unsigned> round_ = 0;                        ///< incremented for each call of share
    std::atomic<std::size_t> busy_ = 0; ///< number of other workers still busy in this round
    std::vector<Other> others_;         ///< last, so that threads are joined before the other members go
};

} // namespace gaspard
