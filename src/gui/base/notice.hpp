// Messages for the user, and their way from other threads to the window's.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace gaspard {

struct Notice {
    std::string text; ///< one sentence
    bool error = false;
};

/// Collects notices from any thread for the window's thread.
class NoticeBoard {
  public:
    /// `notify` is called after every notice, on the thread that added it.
    explicit NoticeBoard(std::function<void()> notify) : notify_(std::move(notify)) {}
    void add(Notice notice);
    void wake(); ///< without a notice: something else is there to collect
    std::vector<Notice> take();

  private:
    std::function<void()> notify_;
    std::mutex mutex_;
    std::vector<Notice> notices_;
};

/// Runs `task`, which returns a sentence about what it did; if it is empty, nothing is said. An exception
/// becomes an error notice; Interrupted is passed on.
void report_outcome(NoticeBoard& board, const std::function<std::string()>& task);

} // namespace gaspard
