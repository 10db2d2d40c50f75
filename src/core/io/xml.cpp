#include "core/io/xml.hpp"

#include "core/base/utf8.hpp"

namespace gaspard {

namespace {

/// The length in bytes of the first UTF-8 character; 0 if it is invalid or not allowed in XML.
std::size_t character_length(std::string_view text) {
    const std::size_t length = utf8_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    if (length == 1) return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
    const bool no_character = text.starts_with("\xef\xbf\xbe") || text.starts_with("\xef\xbf\xbf");
    return no_character ? 0 : length;
}

} // namespace

std::string xml_escape(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0)
            safe += "\uFFFD";
        else if (text[0] == '&')
            safe += "&amp;";
        else if (text[0] == '<')
            safe += "&lt;";
        else if (text[0] == '>')
            safe += "&gt;";
        else if (text[0] == '"')
            safe += "&quot;";
        else
            safe += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return safe;
}

} // namespace gaspard
