#include "gui/base/plot_text.hpp"

namespace gaspard {

std::string shortened(std::string_view text, float width) {
    if (text_size(text).x <= width) return std::string(text);
    // Of UTF-8 only whole letters.
    const auto starts_letter = [&](std::size_t i) {
        return i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xc0U) != 0x80U;
    };
    for (std::size_t kept = text.size(); kept > 0; --kept) {
        const std::size_t head = kept * 2 / 5, tail = text.size() - (kept - head);
        if (!starts_letter(head) || !starts_letter(tail)) continue;
        std::string result = std::string(text.substr(0, head)) + "…" + std::string(text.substr(tail));
        if (text_size(result).x <= width) return result;
    }
    return "…";
}

} // namespace gaspard
