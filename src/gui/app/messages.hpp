// What the program tells the user: the last message for the status bar, the message log, and the dialog for
// errors.
#pragma once

#include "gui/base/notice.hpp"
#include "gui/panels/dialogs.hpp"
#include "gui/panels/log_panel.hpp"

#include <functional>
#include <memory>

namespace gaspard {

class Messages {
  public:
    /// `wake` is called on other threads when they have added a notice to the board.
    explicit Messages(std::function<void()> wake) : board_(std::make_shared<NoticeBoard>(std::move(wake))) {}

    /// Shared, because a task may run when the window is already closing.
    const std::shared_ptr<NoticeBoard>& board() const { return board_; }
    /// Says what other threads have added; true if there was any.
    bool collect();

    /// In the log and the status bar; an error opens the dialog as well.
    void say(Notice notice);
    /// In the log only.
    void note(Notice notice) { log_.add(std::move(notice)); }
    /// In the status bar only.
    void show(Notice notice) { last_ = std::move(notice); }
    /// Empties the status bar.
    void clear() { last_ = {}; }

    const Notice& last() const { return last_; }
    const Log& log() const { return log_; }
    Log& log() { return log_; }
    const ErrorDialog& error() const { return error_; }
    ErrorDialog& error() { return error_; }

  private:
    std::shared_ptr<NoticeBoard> board_;
    Notice last_;
    Log log_;
    ErrorDialog error_;
};

} // namespace gaspard
