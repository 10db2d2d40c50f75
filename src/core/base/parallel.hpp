// Loops over independent items, shared by a few threads.
#pragma once

#include "core/base/stopwatch.hpp"

#include <cstddef>
#include <exception>
#include <numeric>
#include <thread>
#include <vector>

namespace gaspard {

/// Splits 0 .. count into `workers` consecutive ranges and calls work(worker, begin, end) for each on its own
/// thread, the first on the calling thread. Every worker is called, even with an empty range. Rethrows the
/// first exception after all have finished. Returns the CPU seconds of the other threads, which the caller's
/// thread clock does not include.
template <class Work>
double parallel_ranges(std::size_t workers, std::size_t count, const Work& work) {
    std::vector<std::exception_ptr> errors(workers);
    std::vector<double> cpu_seconds(workers);
    const auto call = [&](std::size_t worker) {
        const Stopwatch watch;
        try {
            work(worker, count * worker / workers, count * (worker + 1) / workers);
        } catch (...) {
            errors[worker] = std::current_exception();
        }
        cpu_seconds[worker] = watch.cpu_seconds();
    };
    {
        std::vector<std::jthread> threads; // joined at the end of the block
        for (std::size_t worker = 1; worker < workers; ++worker) threads.emplace_back(call, worker);
        call(0);
    }
    for (const auto& error : errors)
        if (error) std::rethrow_exception(error);
    return std::accumulate(cpu_seconds.begin() + 1, cpu_seconds.end(), 0.0);
}

} // namespace gaspard
