// Ctrl-C as a stop token: the signal is waited for by a thread of its own, so no handler and no global is
// needed.
#pragma once

#include <stop_token>
#include <thread>

namespace gaspard {

class InterruptWatch {
  public:
    /// Blocks SIGINT and SIGTERM for this thread and those it will start.
    InterruptWatch();
    std::stop_token token() const { return source_.get_token(); }

  private:
    std::stop_source source_;
    std::jthread thread_;
};

} // namespace gaspard
