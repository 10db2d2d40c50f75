// Text that is safe between XML's tags and in its attributes.
#pragma once

#include <string>
#include <string_view>

namespace gaspard {

/// `text` is UTF-8; what XML cannot hold at all (control characters, broken UTF-8) becomes U+FFFD.
std::string xml_escape(std::string_view text);

} // namespace gaspard
