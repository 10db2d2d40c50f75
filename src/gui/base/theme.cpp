#include "gui/base/theme.hpp"

#include "core/base/check.hpp"
#include "gui/base/system_fonts.hpp"
#include "gui_assets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

namespace gaspard {

namespace {

constexpr Colour hex(unsigned value, float alpha = 1) {
    const auto part = [value](unsigned shift) {
        return static_cast<float>((value >> shift) & 0xffU) / 255.0F;
    };
    return {part(16), part(8), part(0), alpha};
}

Colour mix(Colour a, Colour b, float t) {
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b), a.a + t * (b.a - a.a)};
}

std::string_view embedded_font(std::string_view name) {
    for (const auto& file : gui_assets::files())
        if (file.path == "assets/fonts/" + std::string(name)) return file.bytes;
    check_failed("the font is embedded");
}

/// Neither white space nor control, and within what ImGui can store.
bool is_drawn(char32_t c) { return c > 0x20 && c <= IM_UNICODE_CODEPOINT_MAX; }

/// As a range of one.
void append_character(std::vector<ImWchar>& ranges, char32_t c) {
    if (is_drawn(c)) ranges.insert(ranges.end(), 2, static_cast<ImWchar>(c));
}

/// Adds the font's characters to the last font of the atlas; `added` keeps what the atlas reads when built.
void add_font(ImFontAtlas& atlas, const SystemFont& font, float size,
              std::vector<std::vector<ImWchar>>& added) {
    std::vector<ImWchar>& ranges = added.emplace_back();
    for (const char32_t c : font.characters) append_character(ranges, c);
    ranges.push_back(0);
    ImFontConfig config;
    config.MergeMode = true;
    config.FontNo = font.number;
    config.OversampleH = 2;
    void* bytes = ImGui::MemAlloc(font.bytes.size()); // the atlas frees it
    std::memcpy(bytes, font.bytes.data(), font.bytes.size());
    atlas.AddFontFromMemoryTTF(bytes, static_cast<int>(font.bytes.size()), size, &config, ranges.data());
}

void set_sizes(ImGuiStyle& style) {
    style.WindowPadding = {14, 12};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 7};
    style.ItemInnerSpacing = {7, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 10;
    style.WindowRounding = 0;
    style.ChildRounding = 6;
    style.PopupRounding = 6;
    style.FrameRounding = 5;
    style.GrabRounding = 5;
    style.ScrollbarRounding = 6;
    style.TabRounding = 5;
    style.WindowBorderSize = 0; // of parts; what comes up has a border
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowTitleAlign = {0, 0.5F};
}

} // namespace

ImU32 packed(Colour c, float opacity) {
    return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a * opacity});
}

namespace {

/// A colour of both themes.
struct ColourRow {
    Colour Theme::*colour;
    Colour dark, light;
};

Theme make_theme(Colour ColourRow::*which) {
    static constexpr ColourRow table[] = {
        {&Theme::background, hex(0x14171c), hex(0xffffff)},
        {&Theme::panel, hex(0x1b1f26), hex(0xf5f6f8)},
        {&Theme::frame, hex(0x272d37), hex(0xe7eaef)},
        {&Theme::border, hex(0x363e4b), hex(0xc4cad4)},
        {&Theme::grid, hex(0x8fa3bf, 0.13F), hex(0x2b3a52, 0.13F)},
        {&Theme::text, hex(0xdde3ec), hex(0x1c222b)},
        {&Theme::faint_text, hex(0x8b97a8), hex(0x5d6877)},
        {&Theme::accent, hex(0x5aa9e6), hex(0x1f74b8)},
        {&Theme::good, hex(0x63c98a), hex(0x1f8a4c)},
        {&Theme::warning, hex(0xe8b04c), hex(0xa86a00)},
        {&Theme::bad, hex(0xef6a6a), hex(0xc23434)},
        {&Theme::surface, hex(0x222832), hex(0xffffff)},
        {&Theme::line_on_dark, hex(0xf2f6ff, 0.62F), hex(0xffffff, 0.6F)},
        {&Theme::line_on_light, hex(0x0b1016, 0.62F), hex(0x10161f, 0.75F)},
        {&Theme::overlay, hex(0xff4a3d), hex(0xd0141e)},
        {&Theme::tangled, hex(0xff2bd6), hex(0xe600b8)},
    };
    static constexpr std::array<Colour, 8> dark_curves = {hex(0x5aa9e6), hex(0xf2a65a), hex(0x63c98a),
                                                          hex(0xe4718f), hex(0xb79cf0), hex(0x58cfd0),
                                                          hex(0xd9c75b), hex(0xa9b4c2)};
    static constexpr std::array<Colour, 8> light_curves = {hex(0x1f74b8), hex(0xd9701a), hex(0x1f8a4c),
                                                           hex(0xc2315a), hex(0x7550c8), hex(0x128a8c),
                                                           hex(0x8f7b00), hex(0x5d6877)};
    Theme theme;
    for (const ColourRow& row : table) theme.*row.colour = row.*which;
    theme.curves = which == &ColourRow::dark ? dark_curves : light_curves;
    return theme;
}

} // namespace

Theme dark_theme() { return make_theme(&ColourRow::dark); }
Theme light_theme() { return make_theme(&ColourRow::light); }

Theme theme_named(std::string_view name) {
    GASPARD_CHECK(name == "dark" || name == "light");
    return name == "light" ? light_theme() : dark_theme();
}

void apply_theme(const Theme& t, float scale) {
    ImGuiStyle style;
    set_sizes(style);
    style.ScaleAllSizes(scale);
    const auto set = [&style](ImGuiCol which, Colour c, float opacity = 1) {
        c.a *= opacity;
        style.Colors[which] = to_imgui(c);
    };
    const Colour hovered = mix(t.frame, t.accent, 0.22F), active = mix(t.frame, t.accent, 0.42F);
    set(ImGuiCol_Text, t.text);
    set(ImGuiCol_TextDisabled, t.faint_text);
    for (const ImGuiCol which : {ImGuiCol_WindowBg, ImGuiCol_MenuBarBg, ImGuiCol_PopupBg, ImGuiCol_TitleBg,
                                 ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed})
        set(which, t.panel);
    set(ImGuiCol_ChildBg, t.panel, 0);
    set(ImGuiCol_BorderShadow, t.panel, 0);
    set(ImGuiCol_ScrollbarBg, t.panel, 0);
    for (const ImGuiCol which : {ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_ScrollbarGrab,
                                 ImGuiCol_TableBorderStrong, ImGuiCol_TableBorderLight})
        set(which, t.border);
    for (const ImGuiCol which : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Tab, ImGuiCol_TabUnfocused,
                                 ImGuiCol_TableHeaderBg, ImGuiCol_Header})
        set(which, t.frame);
    for (const ImGuiCol which :
         {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_TabHovered, ImGuiCol_HeaderHovered,
          ImGuiCol_SeparatorHovered, ImGuiCol_ScrollbarGrabHovered})
        set(which, hovered);
    for (const ImGuiCol which :
         {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive,
          ImGuiCol_HeaderActive, ImGuiCol_SeparatorActive, ImGuiCol_ScrollbarGrabActive})
        set(which, active);
    for (const ImGuiCol which : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_PlotHistogram,
                                 ImGuiCol_PlotLines, ImGuiCol_NavHighlight, ImGuiCol_DragDropTarget})
        set(which, t.accent);
    set(ImGuiCol_SliderGrabActive, mix(t.accent, t.text, 0.35F));
    set(ImGuiCol_PlotHistogramHovered, mix(t.accent, t.text, 0.35F));
    set(ImGuiCol_PlotLinesHovered, mix(t.accent, t.text, 0.35F));
    set(ImGuiCol_TextSelectedBg, t.accent, 0.35F);
    set(ImGuiCol_ResizeGrip, t.border);
    set(ImGuiCol_ResizeGripHovered, hovered);
    set(ImGuiCol_ResizeGripActive, active);
    set(ImGuiCol_TableRowBg, t.panel, 0);
    set(ImGuiCol_TableRowBgAlt, t.frame, 0.35F);
    set(ImGuiCol_ModalWindowDimBg, t.background, 0.6F);
    ImGui::GetStyle() = style;
}

void load_font(ImFontAtlas& atlas, const Theme& theme, float scale, std::string_view text) {
    load_font(atlas, theme, scale, text, {});
    const std::vector<char32_t> missing = missing_characters(atlas, text);
    if (!missing.empty()) load_font(atlas, theme, scale, text, system_fonts(missing));
}

void load_font(ImFontAtlas& atlas, const Theme& theme, float scale, std::string_view text,
               const std::vector<SystemFont>& fonts) {
    static constexpr ImWchar always[] = {0x0020, 0x017f,  // Latin
                                         0x0370, 0x04ff,  // Greek, Cyrillic
                                         0x1d62, 0x1d6a,  // subscripts
                                         0x2010, 0x2027,  // dashes, dots
                                         0x2030, 0x203a,  // per mille, quotation
                                         0x2070, 0x209c,  // superscripts, subscripts
                                         0x2200, 0x22ff}; // signs
    std::vector<ImWchar> ranges(std::begin(always), std::end(always));
    for (const char32_t c : characters_of(text)) append_character(ranges, c);
    ranges.push_back(0);
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = 2;
    atlas.Clear();
    const auto add = [&](std::string_view name, float pixels, const ImWchar* wanted) {
        const std::string_view bytes = embedded_font(name);
        // ImGui asks for writable bytes, but only reads what it does not own.
        return atlas.AddFontFromMemoryTTF(const_cast<char*>(bytes.data()), static_cast<int>(bytes.size()),
                                          pixels, &config, wanted);
    };
    const float size = std::round(theme.font_size * scale);
    const ImFont* font = add("Roboto-Regular.ttf", size, ranges.data());
    std::vector<std::vector<ImWchar>> added;
    for (const SystemFont& found : fonts) add_font(atlas, found, size, added); // into the font before
    static constexpr ImWchar of_formulas[] = {0x0020, 0x00ff, 0x0370, 0x03ff, 0x2010, 0x2027, 0};
    const ImFont* fixed = add("JetBrainsMono-Regular.ttf", std::round(0.93F * size), of_formulas);
    GASPARD_CHECK(font != nullptr && fixed != nullptr && atlas.Build()); // it reads the ranges
}

ImFont* formula_font() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    return atlas.Fonts.Size > 1 ? atlas.Fonts[1] : ImGui::GetFont();
}

std::vector<char32_t> missing_characters(const ImFontAtlas& atlas, std::string_view text) {
    const ImFont& font = *atlas.Fonts.front();
    std::vector<char32_t> missing;
    for (const char32_t c : characters_of(text))
        if (is_drawn(c) && font.FindGlyphNoFallback(static_cast<ImWchar>(c)) == nullptr) missing.push_back(c);
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    return missing;
}

bool lacks_glyphs(const ImFontAtlas& atlas, std::string_view text) {
    return !missing_characters(atlas, text).empty();
}

} // namespace gaspard
