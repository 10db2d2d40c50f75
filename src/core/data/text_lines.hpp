// Lines of text files.
#pragma once

#include <algorithm>
#include <string_view>

namespace gaspard {

/// Takes the first line, without its end, from `rest`. Lines end with LF, CR LF or CR.
inline std::string_view take_line(std::string_view& rest) {
    const auto end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end);
    rest.remove_prefix(rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1);
    return line;
}

} // namespace gaspard
