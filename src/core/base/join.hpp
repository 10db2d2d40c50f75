// Lists of words as one text, and back.
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

/// The parts of `text` between separators: one more than there are separators. They refer to `text`.
inline std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> parts;
    for (std::size_t end = 0; (end = text.find(separator)) != std::string_view::npos;
         text.remove_prefix(end + separator.size()))
        parts.push_back(text.substr(0, end));
    parts.push_back(text);
    return parts;
}

} // namespace gaspard
