// Text in UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace gaspard {

/// The length in bytes of the first character; 0 if it is not valid UTF-8 (also of an empty text).
std::size_t utf8_length(std::string_view text);
bool is_utf8(std::string_view text);

} // namespace gaspard
