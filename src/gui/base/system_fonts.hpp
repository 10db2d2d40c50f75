// Fonts of the system, found by fontconfig, for characters that the embedded font lacks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct SystemFont {
    std::string bytes;                ///< its file: TrueType or OpenType, alone or in a collection
    int number = 0;                   ///< in a collection
    std::vector<char32_t> characters; ///< of those asked for, what it is used for
};

/// As few fonts without serifs as have the characters; a character that no font has is left out.
std::vector<SystemFont> system_fonts(std::vector<char32_t> characters);

/// The characters of a UTF-8 text, in order; bytes that are not UTF-8 are left out.
std::vector<char32_t> characters_of(std::string_view text);

} // namespace gaspard
