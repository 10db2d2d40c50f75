// Lists of words as one text.
#pragma once

#include <string>
#include <string_view>

namespace gaspard {

/// "a, b, c". `words`: a range of what std::string_view is made from.
template <class Words>
std::string join(const Words& words, std::string_view separator) {
    std::string text;
    bool first = true;
    for (const auto& word : words) {
        if (!first) text += separator;
        text += std::string_view(word);
        first = false;
    }
    return text;
}

} // namespace gaspard
