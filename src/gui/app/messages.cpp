#include "gui/app/messages.hpp"

#include <utility>

namespace gaspard {

bool Messages::collect() {
    auto notices = board_->take();
    for (Notice& notice : notices) say(std::move(notice));
    return !notices.empty();
}

void Messages::say(Notice notice) {
    log_.add(notice);
    if (notice.error) error_.show(notice.text);
    last_ = std::move(notice);
}

} // namespace gaspard
