// Asks which files of a run to export, and where to.
#pragma once

#include "gui/base/item_rectangles.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

class ExportDialog {
  public:
    struct Choice {
        std::string formats;  ///< as in output.formats: "obj,svg"
        std::string folder;   ///< as typed
        bool replace = false; ///< files of an earlier export in this folder
    };
    /// `splines`: whether the run has the formats of splines. `folder`: the usual one of this run.
    void show(const std::string& formats, bool splines, std::string folder);
    void close() { open_ = false; }
    bool open() const { return open_; }
    /// Keys "export.FORMAT", "export.folder", "export.browse", "export.replace", "export.ok" and
    /// "export.cancel".
    std::optional<Choice> draw(ItemRectangles& items);
    /// True once after the button that asks for another folder was pressed.
    bool take_browse_wish();
    const std::string& folder() const { return folder_; }
    void set_folder(std::string folder) { folder_ = std::move(folder); }

  private:
    void draw_formats(ItemRectangles& items);
    void draw_folder(ItemRectangles& items);

    bool open_ = false, splines_ = false, browse_ = false, replace_ = false;
    std::vector<bool> chosen_; ///< of formats()
    std::string folder_;
};

} // namespace gaspard
