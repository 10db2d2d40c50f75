// The message log: every message since the program started, with the time of day.
#pragma once

#include "gui/base/item_rectangles.hpp"
#include "gui/base/notice.hpp"
#include "gui/base/theme.hpp"

#include <deque>
#include <string>

namespace gaspard {

struct LogLine {
    std::string time; ///< "14:03:59"
    Notice notice;
};

class Log {
  public:
    void add(Notice notice);
    const std::deque<LogLine>& lines() const { return lines_; }
    /// All lines as text.
    std::string text() const;
    /// Draws into the current ImGui window; keys "log", "log.copy", "log.clear".
    void draw(const Theme& theme, ItemRectangles& items);

  private:
    std::deque<LogLine> lines_; ///< the newest last; the oldest are dropped
    bool grown_ = false;        ///< scroll to the end in the next frame
};

} // namespace gaspard
