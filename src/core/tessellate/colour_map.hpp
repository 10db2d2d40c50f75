// Colour maps. One table serves the window, images and files.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct ColourMap {
    std::string_view name;
    std::span<const std::array<unsigned char, 3>> colours; ///< sRGB, evenly spaced from low to high
    bool diverging = false;                                ///< two hues that meet in a light middle colour
};

/// In menu order; the first is the default for sequential values.
const std::vector<ColourMap>& colour_maps();
const ColourMap& colour_map(std::string_view name); ///< checks that the name is in the table
/// `t` is clamped to [0, 1]; NaN gives the lowest colour.
std::array<unsigned char, 3> colour_at(const ColourMap& map, double t);
/// Whether light lines are seen better on a colour than dark ones.
bool is_dark(std::array<unsigned char, 3> colour);

/// The range of values that a colour map spans.
struct ColourRange {
    double low = 0, high = 1;
    bool logarithmic = false; ///< requires low > 0
    friend bool operator==(const ColourRange&, const ColourRange&) = default;
    /// Relative position: 0 at low, 1 at high, linear or logarithmic, not clamped. For logarithmic ranges,
    /// values <= 0 give 0.
    double position(double value) const;
    /// The inverse of position().
    double value(double position) const;
};
/// The range of the finite values; [0, 1] if there are none.
ColourRange range_of(std::span<const double> values);

} // namespace gaspard
