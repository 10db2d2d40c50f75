#include "gui/base/system_fonts.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/base/release.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fontconfig/fontconfig.h>
#include <memory>

namespace gaspard {

namespace {

constexpr std::uintmax_t largest_font = std::uintmax_t{1} << 26; // 64 MiB: of collections for East Asia, too

using Config = std::unique_ptr<FcConfig, Release<FcConfigDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Release<FcCharSetDestroy>>;
using Pattern = std::unique_ptr<FcPattern, Release<FcPatternDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, Release<FcFontSetDestroy>>;

/// All fonts, the nearest to "sans" with these characters first.
FontSet sorted_fonts(FcConfig* config, const std::vector<char32_t>& characters) {
    const CharSet set(FcCharSetCreate());
    for (const char32_t c : characters) FcCharSetAddChar(set.get(), c);
    const Pattern pattern(FcPatternCreate());
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans"));
    FcPatternAddCharSet(pattern.get(), FC_CHARSET, set.get());
    FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
    FcConfigSubstitute(config, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultMatch;
    return FontSet(FcFontSort(config, pattern.get(), FcTrue, nullptr, &result));
}

/// The beginning of a font with outlines that ImGui's reader knows.
bool is_readable(std::string_view bytes) {
    using namespace std::string_view_literals;
    const std::string_view mark = bytes.substr(0, 4);
    return mark == "\0\1\0\0"sv || mark == "true" || mark == "OTTO" || mark == "ttcf";
}

/// Takes the characters that the font has out of `wanted`; none if it cannot be used.
SystemFont take(FcPattern* pattern, std::vector<char32_t>& wanted) {
    SystemFont font;
    FcChar8* file = nullptr;
    FcCharSet* set = nullptr;
    FcBool outline = FcFalse;
    if (FcPatternGetString(pattern, FC_FILE, 0, &file) != FcResultMatch ||
        FcPatternGetCharSet(pattern, FC_CHARSET, 0, &set) != FcResultMatch ||
        FcPatternGetBool(pattern, FC_OUTLINE, 0, &outline) != FcResultMatch || outline != FcTrue)
        return font;
    std::vector<char32_t> rest;
    for (const char32_t c : wanted)
        (FcCharSetHasChar(set, c) == FcTrue ? font.characters : rest).push_back(c);
    if (font.characters.empty()) return font;
    try {
        font.bytes = read_file(reinterpret_cast<const char*>(file), largest_font);
    } catch (const InputError&) { // too large, or removed since it was listed
        return {};
    }
    if (!is_readable(font.bytes)) return {};
    int index = 0; // above its low 16 bits: an instance of a variable font
    FcPatternGetInteger(pattern, FC_INDEX, 0, &index);
    font.number = index & 0xffff;
    wanted = std::move(rest);
    return font;
}

} // namespace

std::vector<SystemFont> system_fonts(std::vector<char32_t> characters) {
    std::vector<SystemFont> found;
    const Config config(FcInitLoadConfigAndFonts());
    if (!config) return found;
    const FontSet fonts = sorted_fonts(config.get(), characters);
    for (int i = 0; fonts && i < fonts->nfont && !characters.empty(); ++i) {
        SystemFont font = take(fonts->fonts[i], characters);
        if (!font.characters.empty()) found.push_back(std::move(font));
    }
    return found;
}

std::vector<char32_t> characters_of(std::string_view text) {
    std::vector<char32_t> characters;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i++]);
        const int more = byte < 0x80 ? 0 : byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : byte >= 0xc0 ? 1 : -1;
        if (more < 0) continue;
        char32_t c = more == 0 ? byte : byte & (0x3fU >> more);
        int taken = 0;
        for (; taken < more && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0U) == 0x80U;
             ++taken)
            c = (c << 6U) | (static_cast<unsigned char>(text[i++]) & 0x3fU);
        if (taken == more) characters.push_back(c);
    }
    return characters;
}

} // namespace gaspard
