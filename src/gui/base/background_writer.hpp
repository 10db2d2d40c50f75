// Files written off the window's thread. Each task ends in one sentence for the user, of success or of
// failure.
#pragma once

#include "core/io/image.hpp"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace gaspard {

struct Notice {
    std::string text;
    bool error = false;
};

/// Sentences on their way from any thread to the window's.
class NoticeBoard {
  public:
    /// `notify` is called after every notice, on the thread that gave it.
    explicit NoticeBoard(std::function<void()> notify) : notify_(std::move(notify)) {}
    void add(Notice notice);
    std::vector<Notice> take();

  private:
    std::function<void()> notify_;
    std::mutex mutex_;
    std::vector<Notice> notices_;
};

/// Runs `task`, which returns what it has done, and turns an exception into a notice of failure, all but
/// Interrupted.
void report_outcome(NoticeBoard& board, const std::function<std::string()>& task);

/// "view.png", or where that exists "view-2.png", "view-3.png" ...
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& ending);

/// Does tasks one after the other on a thread of its own; its end waits for all of them, so that none is
/// lost.
class BackgroundWriter {
  public:
    explicit BackgroundWriter(std::shared_ptr<NoticeBoard> board);
    ~BackgroundWriter();
    /// `task` returns what it has done, as a sentence; an exception is a notice of failure.
    void run(std::function<std::string()> task);
    /// "NAME.png" or the next free name in `folder`.
    void write_image(std::filesystem::path folder, std::string name, Image image);

  private:
    void work(std::stop_token stop);

    std::shared_ptr<NoticeBoard> board_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::deque<std::function<std::string()>> tasks_;
    std::jthread thread_; ///< last, so that it ends before what it uses
};

} // namespace gaspard
