// From numbers to colours. One table of maps serves window, pictures and files.
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
    bool diverging = false; ///< two hues from a pale middle, for values that have one
};

/// In the order in which they are offered; the first is the one for values that go from low to high.
const std::vector<ColourMap>& colour_maps();
const ColourMap& colour_map(std::string_view name); ///< checked: the name is in the table
/// `t` is clamped to [0, 1]; NaN gives the lowest colour.
std::array<unsigned char, 3> colour_at(const ColourMap& map, double t);

/// The interval of values that the map spans.
struct ColourRange {
    double low = 0, high = 1;
    bool logarithmic = false; ///< needs 0 < low
    friend bool operator==(const ColourRange&, const ColourRange&) = default;
    /// 0 at low, 1 at high, beyond them outside; of a logarithmic range 0 where there is no logarithm.
    double position(double value) const;
    /// Where a position lies: the inverse of position().
    double value(double position) const;
};
/// Of the finite values; 0 to 1 where there is none.
ColourRange range_of(std::span<const double> values);

} // namespace gaspard
