#include "gui/base/notice.hpp"

#include "core/base/error.hpp"

#include <exception>
#include <utility>

namespace gaspard {

void NoticeBoard::add(Notice notice) {
    {
        std::lock_guard lock(mutex_);
        notices_.push_back(std::move(notice));
    }
    wake();
}

void NoticeBoard::wake() {
    if (notify_) notify_();
}

std::vector<Notice> NoticeBoard::take() {
    std::lock_guard lock(mutex_);
    return std::exchange(notices_, {});
}

void report_outcome(NoticeBoard& board, const std::function<std::string()>& task) {
    try {
        std::string said = task();
        said.empty() ? board.wake() : board.add({std::move(said), false});
    } catch (const Interrupted&) {
        throw; // reported where it was cancelled
    } catch (const std::exception& error) {
        board.add({error.what(), true});
    }
}

} // namespace gaspard
