#include "core/base/team.hpp"

#include "core/base/check.hpp"

#include <numeric>

namespace gaspard {

Team::Team(std::size_t workers) {
    GASPARD_CHECK(workers >= 1);
    others_.resize(workers - 1); // sized once: an Other must not move while its thread runs
    for (std::size_t i = 0; i < others_.size(); ++i)
        others_[i].thread = std::jthread([this, i] { work_until_stopped(i + 1); });
}

Team::~Team() {
    work_ = nullptr;
    ++round_;
    round_.notify_all();
}

void Team::work_until_stopped(std::size_t worker) {
    Other& me = others_[worker - 1];
    for (unsigned seen = 0;; ++seen) {
        round_.wait(seen);
        if (!work_) return;
        const Stopwatch watch;
        try {
            (*work_)(worker);
        } catch (...) {
            me.error = std::current_exception();
        }
        me.cpu_seconds += watch.cpu_seconds();
        if (--busy_ == 0) busy_.notify_one();
    }
}

void Team::call_all(const std::function<void(std::size_t)>& work) {
    work_ = &work;
    busy_ = others_.size();
    ++round_;
    round_.notify_all();
    std::exception_ptr error;
    try {
        work(0);
    } catch (...) {
        error = std::current_exception();
    }
    for (std::size_t left = busy_; left > 0; left = busy_) busy_.wait(left);
    for (Other& other : others_) {
        if (!error) error = other.error;
        other.error = nullptr;
    }
    if (error) std::rethrow_exception(error);
}

double Team::other_cpu_seconds() const {
    return std::accumulate(others_.begin(), others_.end(), 0.0,
                           [](double sum, const Other& other) { return sum + other.cpu_seconds; });
}

} // namespace gaspard
