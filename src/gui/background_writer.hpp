// Files written off the window's thread. Each task ends in one sentence for the user, of success or of
// failure.
#pragma once

#include "core/io/image.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
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

/// Runs `task`, which returns what it has done, and turns an exception into a notice of failure.
void report_outcome(NoticeBoard& board, const std::function<std::string()>& task);

/// "view.png", or where that exists "view-2.png", "view-3.png" ...
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& ending);

/// Encodes and writes pictures on threads of its own; its end waits for them, so that none is lost.
class PictureWriter {
  public:
    explicit PictureWriter(std::shared_ptr<NoticeBoard> board) : board_(std::move(board)) {}
    /// Into "NAME.png", or where that exists "NAME-2.png" ...
    void write(std::filesystem::path folder, std::string name, Image image);

  private:
    std::shared_ptr<NoticeBoard> board_;
    std::mutex one_at_a_time_; ///< so that two pictures never choose the same name
    std::vector<std::jthread> threads_;
};

} // namespace gaspard
