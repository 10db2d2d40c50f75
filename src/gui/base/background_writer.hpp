// Reads and writes files on a thread of its own. Each task ends with at most one sentence for the user.
#pragma once

#include "gui/base/notice.hpp"
#include "gui/base/output_folders.hpp"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace gaspard {

/// "view.png", or if that exists "view-2.png", "view-3.png" ...
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& ending);

/// Runs tasks one after the other. The destructor waits for all of them.
class BackgroundWriter {
  public:
    explicit BackgroundWriter(std::shared_ptr<NoticeBoard> board);
    ~BackgroundWriter();
    /// `task` returns a sentence about what it did, or nothing to say; an exception becomes an error notice.
    void run(std::function<std::string()> task);
    /// Writes to "NAME.ENDING", or to the next free name, in the folder of this name.
    void write_new(OutputFolders folders, std::string folder, std::string name, std::string ending,
                   std::function<void(const std::filesystem::path&)> write);

  private:
    void work(std::stop_token stop);

    std::shared_ptr<NoticeBoard> board_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::deque<std::function<std::string()>> tasks_;
    std::jthread thread_; ///< last, so that it ends before what it uses
};

} // namespace gaspard
