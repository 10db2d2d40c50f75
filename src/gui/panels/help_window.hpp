// Windows of the menu Help: keys and mouse in groups with a search field, and what the program is.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

struct HelpGroup {
    std::string_view title;                                ///< of a menu, or "Mouse"
    std::vector<std::pair<std::string, std::string>> rows; ///< keys or gesture, what they do
};
/// The actions by menu and the mouse, as far as a row has all words of `search`, in any case; groups without
/// a row are left out.
std::vector<HelpGroup> help_groups(std::span<const Action> actions, std::string_view search);

class HelpWindow {
  public:
    void toggle() { open_ = !open_, search_.clear(), fresh_ = open_; }
    void close() { open_ = false; }
    bool open() const { return open_; }
    /// Key "help.search".
    void draw(std::span<const Action> actions, const Theme& theme, ItemRectangles& items);

  private:
    bool open_ = false, fresh_ = false;
    std::string search_;
};

/// Version, licence, documentation, and versions of libraries, one line each.
std::vector<std::pair<std::string, std::string>> about_lines();

class AboutWindow {
  public:
    void toggle() { open_ = !open_; }
    void close() { open_ = false; }
    bool open() const { return open_; }
    /// Key "about.copy".
    void draw(const Theme& theme, ItemRectangles& items);

  private:
    bool open_ = false;
};

} // namespace gaspard
