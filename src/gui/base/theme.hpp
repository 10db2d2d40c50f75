// How everything looks: one set of colours and sizes for ImGui, the mesh, legends and plots.
//
// Colours are sRGB with straight alpha, 0 to 1. Sizes are in pixels of a display of scale 1; drawing
// code multiplies by `scale` (2 on a high-density display, or for a large image).
#pragma once

#include <array>
#include <imgui.h>
#include <string_view>
#include <vector>

namespace gaspard {

struct SystemFont;

struct Colour {
    float r = 0, g = 0, b = 0, a = 1;
    friend bool operator==(const Colour&, const Colour&) = default;
};

inline Colour opaque(Colour c) { return {c.r, c.g, c.b, 1}; }
inline ImVec4 to_imgui(Colour c) { return {c.r, c.g, c.b, c.a}; }
/// Packed as ImDrawList wants it; `opacity` multiplies the alpha.
ImU32 packed(Colour c, float opacity = 1);

struct Theme {
    Colour background; ///< behind a mesh; of alpha 0 in a transparent image
    Colour panel;      ///< windows, legends
    Colour frame;      ///< fields, sliders, the inside of plots
    Colour border, grid;
    Colour text, faint_text;
    Colour accent;                      ///< what can be grabbed or is selected
    Colour good, warning, bad;          ///< of a status
    Colour surface;                     ///< cells without a colour map
    Colour line_on_dark, line_on_light; ///< cell edges, by what lies below them
    Colour overlay;                     ///< lines of another mesh
    Colour tangled;                     ///< inverted cells; distinct from every colour map
    std::array<Colour, 8> curves;
    float font_size = 15;
    float line_width = 1.0F; ///< of cell edges
    friend bool operator==(const Theme&, const Theme&) = default;
};

Theme dark_theme();
Theme light_theme();
/// "dark" or "light".
Theme theme_named(std::string_view name);

/// Sets the current ImGui context's style.
void apply_theme(const Theme& theme, float scale);

/// Makes the embedded fonts those of `atlas`, at the theme's size times `scale`: one for texts (Latin, Greek,
/// Cyrillic, superscripts and some signs), and one with letters of equal width for formulas. Characters of
/// `text` (UTF-8) that the first one lacks are taken from fonts of the system, where there are any. Its
/// texture is made by ImGuiRenderer. This may take seconds.
void load_font(ImFontAtlas& atlas, const Theme& theme, float scale, std::string_view text = {});
/// The same with these fonts of the system, which were found before, for all their characters.
void load_font(ImFontAtlas& atlas, const Theme& theme, float scale, std::string_view text,
               const std::vector<SystemFont>& fonts);
/// The font with letters of equal width; the current one if the atlas has none.
ImFont* formula_font();
/// The characters of `text` for which the atlas has no glyph, each once.
std::vector<char32_t> missing_characters(const ImFontAtlas& atlas, std::string_view text);
/// Whether there are any.
bool lacks_glyphs(const ImFontAtlas& atlas, std::string_view text);

} // namespace gaspard
