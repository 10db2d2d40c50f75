// Superscript characters of short texts: "10⁻⁸", "x²".
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace gaspard {

/// A superscript digit or minus at the front of `text`: its bytes and what it raises; {0, ""} for others.
constexpr std::pair<std::size_t, std::string_view> superscript(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 11> table = {{{"⁰", "0"},
                                                                                      {"¹", "1"},
                                                                                      {"²", "2"},
                                                                                      {"³", "3"},
                                                                                      {"⁴", "4"},
                                                                                      {"⁵", "5"},
                                                                                      {"⁶", "6"},
                                                                                      {"⁷", "7"},
                                                                                      {"⁸", "8"},
                                                                                      {"⁹", "9"},
                                                                                      {"⁻", "−"}}};
    for (const auto& [character, raised] : table)
        if (text.starts_with(character)) return {character.size(), raised};
    return {0, {}};
}

} // namespace gaspard
