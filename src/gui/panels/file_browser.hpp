// A dialog that browses folders: to open a file, to save one, or to choose a folder.
//
// The path can be typed: the list shows the names that begin as typed (else those that contain it), Tab
// completes, Up and Down move through the list, Enter opens the selected folder or accepts, and Backspace at
// the end of a folder goes up. A double click does what Enter does. It reads nothing itself: the caller
// fulfils take_wish(), on another thread, and passes the answer to set_listing().
#pragma once

#include "gui/base/folder_listing.hpp"
#include "gui/base/item_rectangles.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct ImGuiInputTextCallbackData;

namespace gaspard {

enum class BrowseMode { open, save, folder };

struct BrowsePurpose {
    BrowseMode mode = BrowseMode::open;
    std::string keys = "open";               ///< of its items: "open.path"
    std::string title{}, line{};             ///< "Open", and what is asked for
    std::vector<std::string_view> endings{}; ///< of the files that fit; empty: all
    std::string start{};                     ///< the path at first; "/a/b/" lists that folder
    std::string ending{};                    ///< that a name to save under gets if it has none: ".toml"
};

class FileBrowser {
  public:
    void show(BrowsePurpose purpose);
    void close() { open_ = false; }
    bool open() const { return open_; }
    bool opening() const { return open_ && !ready_; } ///< its text field does not take input yet
    const BrowsePurpose& purpose() const { return purpose_; }

    /// Paths that can be selected at once.
    struct Recent {
        std::span<const std::string> files{}, folders{};
    };
    /// The path once the user has chosen it, with ~ expanded. To save to a file that exists has to be
    /// confirmed. `further` draws more fields above the buttons, and returns whether Enter was pressed there.
    /// Keys (after "KEYS."): "path", "up", "home", "recent", "new-folder", "new-name", "new-ok", "all",
    /// "hidden", "entry.NAME", "ok", "cancel".
    std::optional<std::string> draw(const Recent& recent, ItemRectangles& items,
                                    const std::function<bool()>& further = {});
    /// What is to be read or made, once.
    std::optional<FolderWish> take_wish();
    void set_listing(FolderListing listing);

  private:
    using Entry = FolderListing::Entry;
    static int edit(ImGuiInputTextCallbackData* data);
    std::string key(std::string_view item) const { return purpose_.keys + "." + std::string(item); }
    void go_to(const std::filesystem::path& folder);
    void go_up();
    void set_text(std::string text);
    void move_selection(int by);
    std::string completion() const;
    void update_shown();
    bool draw_field(ItemRectangles& items);
    bool take_keys();
    void draw_buttons_above(const Recent& recent, ItemRectangles& items);
    void draw_new_folder(ItemRectangles& items);
    bool draw_list(float height, ItemRectangles& items);
    bool draw_entry(const Entry& entry, ItemRectangles& items);
    void draw_filters(ItemRectangles& items);
    std::optional<std::string> accept();
    std::string typed_path() const;
    const Entry* selected_entry() const;

    bool open_ = false, ready_ = false;
    BrowsePurpose purpose_;
    std::string text_;                      ///< of the field
    std::string find_;                      ///< what was typed of a name
    std::string selected_;                  ///< a name of the list; empty: none
    std::string present_;                   ///< the file that the user was asked whether to replace
    bool refocus_ = false, at_end_ = false; ///< the text was changed from outside the field
    bool scroll_ = false;                   ///< to the selected entry
    bool naming_ = false;                   ///< a new folder
    std::string new_name_;
    bool all_ = false, hidden_ = false;
    std::optional<std::filesystem::path> to_make_;
    FolderWish wanted_; ///< what was asked for last
    FolderListing listing_;
    std::vector<const Entry*> shown_; ///< of the listing, in their order
    int sort_column_ = 0;             ///< name, size or time
    bool descending_ = false;
};

} // namespace gaspard
