// A few threads that wait for work, so that short pieces of it can be shared without starting threads anew.
#pragma once

#include "core/base/stopwatch.hpp"

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace gaspard {

/// The thread that makes a team is its first worker. Calls must come from one thread at a time.
class Team {
  public:
    explicit Team(std::size_t workers = 1);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    std::size_t workers() const { return 1 + others_.size(); }
    /// Calls work(worker, begin, end) for as many ranges as there are workers; together they are 0 .. count.
    /// Every worker is called, also with an empty range. The first exception is rethrown at the end.
    template <class Work>
    void share(std::size_t count, const Work& work) {
        if (others_.empty()) return work(std::size_t{0}, std::size_t{0}, count);
        const std::size_t all = workers();
        call_all(
            [&, all](std::size_t worker) { work(worker, count * worker / all, count * (worker + 1) / all); });
    }
    /// CPU time that the other workers have spent so far, which the caller's own clock does not see.
    double other_cpu_seconds() const;

  private:
    struct Other {
        std::jthread thread;
        std::exception_ptr error;
        double cpu_seconds = 0;
    };
    void call_all(const std::function<void(std::size_t)>& work);
    void work_until_stopped(std::size_t worker);

    const std::function<void(std::size_t)>* work_ = nullptr; ///< none: the workers are to end
    std::atomic<unsigned> round_ = 0;                        ///< grows when there is work
    std::atomic<std::size_t> busy_ = 0; ///< other workers that have not finished the round
    std::vector<Other> others_;         ///< the last member: its threads end before the others go
};

} // namespace gaspard
