#include "core/tessellate/background.hpp"

#include "core/base/error.hpp"

#include <charconv>

namespace gaspard {

Background parse_background(std::string_view text) {
    if (text == "theme") return {};
    if (text == "transparent") return {Background::Kind::transparent, {}};
    Background background{Background::Kind::colour, {}};
    bool valid = text.size() == 7 && text[0] == '#';
    for (std::size_t i = 0; valid && i < 3; ++i) {
        const char* first = text.data() + 1 + 2 * i;
        const auto [end, code] = std::from_chars(first, first + 2, background.colour[i], 16);
        valid = code == std::errc() && end == first + 2;
    }
    if (!valid)
        throw InputError(
            "view.background must be theme, transparent or a colour as #rrggbb, such as #ffffff, not '" +
            std::string(text) + "'");
    return background;
}

} // namespace gaspard
