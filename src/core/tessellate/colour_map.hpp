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
};

const std::vector<ColourMap>& colour_maps();
const ColourMap& colour_map(std::string_view name); ///< checked: the name is in the table
/// `t` is clamped to [0, 1]; NaN gives the lowest colour.
std::array<unsigned char, 3> colour_at(const ColourMap& map, double t);

/// The interval of values that the map spans.
struct ColourRange {
    double low = 0, high = 1;
    friend bool operator==(const ColourRange&, const ColourRange&) = default;
    double position(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};
ColourRange range_of(std::span<const double> values);

} // namespace gaspard
