// Escaping of text for XML content and attributes.
#pragma once

#include <string>
#include <string_view>

namespace gaspard {

/// `text` is UTF-8; characters that XML cannot represent (control characters, invalid UTF-8) become U+FFFD.
std::string xml_escape(std::string_view text);

} // namespace gaspard
