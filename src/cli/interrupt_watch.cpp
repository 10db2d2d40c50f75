#include "cli/interrupt_watch.hpp"

#include <csignal>
#include <ctime>

namespace gaspard {

InterruptWatch::InterruptWatch() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    // A signal that is blocked arrives even where it is ignored: what nohup started goes on.
    struct sigaction hang_up {};
    if (sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler != SIG_IGN)
        sigaddset(&signals, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    thread_ = std::jthread([signals, shared = shared_](std::stop_token stop) {
        const timespec interval{0, 50'000'000}; // maximum delay at program exit
        while (!stop.stop_requested())
            if (sigtimedwait(&signals, nullptr, &interval) > 0) {
                const std::lock_guard lock(shared->mutex);
                shared->source.request_stop();
            }
    });
}

std::stop_token InterruptWatch::token() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->source.get_token();
}

std::stop_token InterruptWatch::restart() {
    const std::lock_guard lock(shared_->mutex);
    shared_->source = std::stop_source();
    return shared_->source.get_token();
}

} // namespace gaspard
