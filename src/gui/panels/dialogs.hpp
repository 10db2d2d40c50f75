// Dialogs over the window: errors, opening and saving files, help, progress. They are ImGui calls and values;
// the caller draws each of them once a frame.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/folder_listing.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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

/// Asks for a file: its path can be typed, or chosen from what is in its folder and from recent files.
class OpenDialog {
  public:
    struct Purpose {
        std::string title, line;                 ///< "Open", and what is asked for
        std::vector<std::string_view> endings{}; ///< of the files that are listed
        std::string start{};                     ///< the path at first; "/a/b/" lists that folder
        bool recent = false;                     ///< with the recent files
    };
    void show(Purpose purpose);
    void close() { open_ = false; }
    bool open() const { return open_; }
    bool opening() const { return open_ && !ready_; } ///< its text field does not take input yet
    /// The path once the user has chosen it. Keys "open.path", "open.ok", "open.cancel", "open.recent.0",
    /// ..., "open.entry.NAME" and "open.up".
    std::optional<std::string> draw(const std::vector<std::string>& recent, ItemRectangles& items);
    /// A folder whose names are needed, once.
    std::optional<std::filesystem::path> take_folder_wish();
    void set_listing(FolderListing listing) { listing_ = std::move(listing); }
    const Purpose& purpose() const { return purpose_; }

  private:
    std::optional<std::string> draw_listing(ItemRectangles& items);

    bool open_ = false, ready_ = false;
    Purpose purpose_;
    std::string text_;
    bool refocus_ = false, at_end_ = false; ///< the text was changed from outside the field
    std::filesystem::path wanted_;          ///< the folder that was asked for last
    FolderListing listing_;
};

/// Asks where to save a scenario, and under which title. To replace a file has to be confirmed.
class SaveDialog {
  public:
    struct Choice {
        std::string file, title;
        bool packed = false; ///< with the content of its data files
    };
    /// `with_data`: the scenario refers to files, which can be packed into it.
    void show(std::string file, std::string title, bool with_data);
    void close() { open_ = false; }
    bool open() const { return open_; }
    bool opening() const { return open_ && !ready_; } ///< its text field does not take input yet
    /// The choice once the user has made it; the name ends in ".toml". Keys "save.path", "save.title",
    /// "save.pack", "save.ok", "save.cancel".
    std::optional<Choice> draw(ItemRectangles& items);

  private:
    bool open_ = false, ready_ = false;
    Choice choice_;
    bool with_data_ = false;
    std::string present_; ///< the file that the user was asked whether to replace
};

/// A progress bar in the lower left corner of `over`; true when Cancel was pressed. Keys "progress" and
/// "progress.cancel".
bool draw_progress(const std::string& what, double fraction, const ItemRectangle& over,
                   ItemRectangles& items);

} // namespace gaspard
