// Dialogs over the window: errors, opening a scenario file, help, progress. They are ImGui calls and values;
// the caller draws each of them once a frame.
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

/// An error message that the user has to confirm. The solver goes on meanwhile.
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

/// Asks for the path of a scenario file, with a list of recent files.
class OpenDialog {
  public:
    void show() { open_ = true, ready_ = false, text_.fill('\0'); }
    void close() { open_ = false; }
    bool open() const { return open_; }
    bool opening() const { return open_ && !ready_; } ///< its text field does not take input yet
    /// The path once the user has chosen it. Keys "open.path", "open.ok", "open.recent.0", ...
    std::optional<std::string> draw(const std::vector<std::string>& recent, ItemRectangles& items);

  private:
    bool open_ = false, ready_ = false;
    std::array<char, 4096> text_{};
};

/// Asks where to save a scenario, and under which title. To replace a file has to be confirmed.
class SaveDialog {
  public:
    struct Choice {
        std::string file, title;
    };
    void show(std::string file, std::string title);
    void close() { open_ = false; }
    bool open() const { return open_; }
    bool opening() const { return open_ && !ready_; } ///< its text field does not take input yet
    /// The choice once the user has made it; the name ends in ".toml". Keys "save.path", "save.title",
    /// "save.ok", "save.cancel".
    std::optional<Choice> draw(ItemRectangles& items);

  private:
    bool open_ = false, ready_ = false;
    Choice choice_;
    std::string present_; ///< the file that the user was asked whether to replace
};

/// A table of all actions with their keys, and of what the mouse does.
void draw_help(bool& open, std::span<const Action> actions, const Theme& theme);

/// A progress bar in the lower left corner of `over`; true when Cancel was pressed. Keys "progress" and
/// "progress.cancel".
bool draw_progress(const std::string& what, double fraction, const ItemRectangle& over,
                   ItemRectangles& items);

} // namespace gaspard
