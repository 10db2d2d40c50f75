// The panel that compares methods: which ones, their progress, and the table of results. It consists of ImGui
// calls and values; the document owns the runs.
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
    /// The button that was pressed.
    enum class Wish { none, begin, cancel, copy, meshes };
    /// A movable window, which begins at `area` (that of the plots), so that the meshes stay in sight.
    /// Keys "compare", "compare.METHOD", "compare.begin" ("compare.cancel" during a comparison),
    /// "compare.copy" and "compare.meshes".
    Wish draw(const Document& document, const Catalogue& catalogue, const ItemRectangle& area,
              const Theme& theme, ItemRectangles& items);
    /// The methods to compare: of those for the active run's problem, in the catalogue's order.
    std::vector<std::string> chosen(const Document& document, const Catalogue& catalogue) const;

  private:
    Wish draw_buttons(const Document& document, const Catalogue& catalogue, ItemRectangles& items);
    void draw_methods(const Document& document, const Catalogue& catalogue, ItemRectangles& items);

    bool open_ = false;
    std::set<std::string> left_out_; ///< methods that are not ticked
};

} // namespace gaspard
