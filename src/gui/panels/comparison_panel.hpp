// Choosing methods to compare, watching them work, and the table of what they made of the problem. ImGui
// calls and values; the runs are the document's.
#pragma once

#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"
#include "gui/document/document.hpp"

#include <set>
#include <string>

namespace gaspard {

class ComparisonPanel {
  public:
    void show() { open_ = true; }
    void close() { open_ = false; }
    bool open() const { return open_; }
    /// Which button was pressed.
    enum class Wish { none, begin, cancel, copy, meshes };
    /// Keys "compare", "compare.METHOD", "compare.begin" (or "compare.cancel" while methods work),
    /// "compare.copy" and "compare.meshes".
    Wish draw(const Document& document, const Catalogue& catalogue, const Theme& theme,
              ItemRectangles& items);
    /// Of those that go with the first run's problem, in the catalogue's order.
    std::vector<std::string> chosen(const Document& document, const Catalogue& catalogue) const;

  private:
    bool open_ = false;
    std::set<std::string> left_out_; ///< methods without a tick
};

} // namespace gaspard
