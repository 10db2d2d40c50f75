// Dialogs over the window: errors, help, progress. They are ImGui calls and values;
// the caller draws each of them once a frame.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>

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

/// A progress bar in the lower left corner of `over`; true when Cancel was pressed. Keys `key` and
/// "KEY.cancel".
bool draw_progress(const std::string& what, double fraction, const ItemRectangle& over, ItemRectangles& items,
                   const std::string& key = "progress");

} // namespace gaspard
