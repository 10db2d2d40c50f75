// What comes up over the window and goes away again: errors, the choice of a scenario file, the help. They
// are ImGui calls and values; the caller draws each of them once a frame.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

/// One sentence that somebody has to have seen. Nothing behind it is lost or stopped.
class ErrorDialog {
  public:
    void show(std::string sentence) { sentence_ = std::move(sentence); }
    void close() { sentence_.clear(); }
    bool open() const { return !sentence_.empty(); }
    const std::string& sentence() const { return sentence_; }
    /// Keys "error" and "error.ok".
    void draw(ItemRectangles& items);

  private:
    std::string sentence_;
};

/// Asks for the path of a scenario file; offers those opened before.
class OpenDialog {
  public:
    void show() { open_ = true, ready_ = false, text_.fill('\0'); }
    void close() { open_ = false; }
    bool open() const { return open_; }
    bool opening() const { return open_ && !ready_; } ///< its field cannot be written in yet
    /// The path, once it has been chosen. Keys "open.path", "open.ok", "open.recent.0", ...
    std::optional<std::string> draw(const std::vector<std::string>& recent, ItemRectangles& items);

  private:
    bool open_ = false, ready_ = false;
    std::array<char, 4096> text_{};
};

/// Every action with its keys, and what the mouse does.
void draw_help(bool& open, std::span<const Action> actions, const Theme& theme);

/// A bar for work under way, over the lower left corner of `over`; true when its Cancel was pressed. Keys
/// "progress" and "progress.cancel".
bool draw_progress(const std::string& what, double fraction, const ItemRectangle& over,
                   ItemRectangles& items);

} // namespace gaspard
