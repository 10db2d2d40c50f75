// Everything the program has said since it began, with the time of day, for those who want to look again.
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
    /// All lines as text, for the clipboard.
    std::string text() const;
    /// Into the current ImGui window; keys "log", "log.copy", "log.clear".
    void draw(const Theme& theme, ItemRectangles& items);

  private:
    std::deque<LogLine> lines_; ///< the newest last; old ones are dropped
    bool grown_ = false;        ///< scroll to the end
};

} // namespace gaspard
