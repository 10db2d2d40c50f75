// Wall time and CPU time of the calling thread since construction.
#pragma once

#include <chrono>
#include <ctime>

namespace gaspard {

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - wall_).count(); }
    double cpu_seconds() const { return thread_cpu() - cpu_; }

  private:
    using Clock = std::chrono::steady_clock;
    static double thread_cpu() {
        timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    }
    Clock::time_point wall_ = Clock::now();
    double cpu_ = thread_cpu();
};

} // namespace gaspard
