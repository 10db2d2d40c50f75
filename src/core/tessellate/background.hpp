// The background of images: the value of view.background.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace gaspard {

struct Background {
    enum class Kind { theme, transparent, colour };
    Kind kind = Kind::theme;
    std::array<unsigned char, 3> colour{}; ///< sRGB, of kind colour
    friend bool operator==(const Background&, const Background&) = default;
};

/// "theme", "transparent" or "#rrggbb". Throws InputError with one sentence.
Background parse_background(std::string_view text);

} // namespace gaspard
