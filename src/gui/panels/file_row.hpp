// A row whose value names a file: the name, and a button that asks for another one.
#pragma once

#include "core/base/parameter.hpp"
#include "gui/base/item_rectangles.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace gaspard {

/// A wish to choose a file for a value.
struct FileWish {
    std::string key;     ///< "monitor.file"
    std::string title;   ///< "File"
    std::string present; ///< the value
};

/// What a value of a row with the role `file` is called: the name of the file without its folders, "data in
/// the scenario, 12 kB", or "Choose a file".
std::string file_label(std::string_view value);

/// Draws the row's control, `width` wide, and returns whether it was pressed. Key `key`.
bool draw_file(const std::string& key, std::string_view value, float width, ItemRectangles& items);

} // namespace gaspard
