// Ctrl-C as a stop token. A dedicated thread waits for the signal, which avoids signal handlers and globals.
#pragma once

#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>

namespace gaspard {

class InterruptWatch {
  public:
    /// Blocks SIGINT, SIGTERM and, unless it is ignored, SIGHUP in this thread and in threads that it starts.
    InterruptWatch();
    /// Stopped by a signal that arrives from now on, or has arrived since the last call of restart().
    std::stop_token token() const;
    /// A signal so far has ended one part of the work; the next one ends the next part. Returns its token.
    std::stop_token restart();

  private:
    struct Shared {
        std::mutex mutex;
        std::stop_source source;
    };
    std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
    std::jthread thread_;
};

} // namespace gaspard
