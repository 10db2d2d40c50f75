// Ctrl-C as a stop token. A dedicated thread waits for the signal, which avoids signal handlers and globals.
#pragma once

#include <stop_token>
#include <thread>

namespace gaspard {

class InterruptWatch {
  public:
    /// Blocks SIGINT, SIGTERM and, unless it is ignored, SIGHUP in this thread and in threads that it starts.
    InterruptWatch();
    std::stop_token token() const { return source_.get_token(); }

  private:
    std::stop_source source_;
    std::jthread thread_;
};

} // namespace gaspard
