#include "core/tessellate/colour_map.hpp"

#include "core/base/check.hpp"
#include "core/base/finite_range.hpp"
#include "core_assets.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gaspard {

namespace {

using Colour = std::array<unsigned char, 3>;

struct OwnedMap {
    std::string name;
    std::vector<Colour> colours;
};

/// Parses a line "red,green,blue" of a colour map file; numbers from 0 to 255.
Colour parse_colour(std::string_view line) {
    Colour colour{};
    const char* at = line.data();
    const char* end = at + line.size();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [next, error] = std::from_chars(at, end, colour[i]);
        GASPARD_CHECK(error == std::errc());
        at = next;
        if (i < 2) GASPARD_CHECK(at != end && *at++ == ',');
    }
    GASPARD_CHECK(at == end);
    return colour;
}

OwnedMap parse_map(std::string_view path, std::string_view text) {
    OwnedMap map;
    const std::size_t begin = path.rfind('/') + 1;
    map.name = path.substr(begin, path.rfind('.') - begin);
    bool heading = true;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (!heading) map.colours.push_back(parse_colour(text.substr(0, end)));
        heading = false;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    GASPARD_CHECK(map.colours.size() >= 2);
    return map;
}

struct Entry {
    std::string_view name;
    bool diverging;
};
constexpr Entry order[] = {{"viridis", false}, {"plasma", false},      {"ember", false},
                           {"grey", false},    {"blue-yellow", false}, {"blue-red", true}};

std::vector<OwnedMap> parse_maps() {
    std::vector<OwnedMap> maps;
    for (const auto& file : core_assets::files())
        if (file.path.starts_with("assets/colour_maps/")) maps.push_back(parse_map(file.path, file.bytes));
    GASPARD_CHECK(maps.size() == std::size(order));
    return maps;
}

std::vector<ColourMap> make_table() {
    static const std::vector<OwnedMap> owned = parse_maps();
    std::vector<ColourMap> table;
    for (const Entry& entry : order) {
        const auto map =
            std::find_if(owned.begin(), owned.end(), [&](const OwnedMap& m) { return m.name == entry.name; });
        GASPARD_CHECK(map != owned.end());
        table.push_back({map->name, map->colours, entry.diverging});
    }
    return table;
}

} // namespace

const std::vector<ColourMap>& colour_maps() {
    static const std::vector<ColourMap> table = make_table();
    return table;
}

const ColourMap& colour_map(std::string_view name) {
    for (const auto& map : colour_maps())
        if (map.name == name) return map;
    check_failed("the colour map is in the table");
}

std::array<unsigned char, 3> colour_at(const ColourMap& map, double t) {
    const double last = static_cast<double>(map.colours.size() - 1);
    const double position = std::isnan(t) ? 0 : std::clamp(t, 0.0, 1.0) * last;
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, map.colours.size() - 1);
    const double share = position - static_cast<double>(below);
    Colour colour{};
    for (std::size_t i = 0; i < 3; ++i)
        colour[i] = static_cast<unsigned char>(
            std::lround((1 - share) * map.colours[below][i] + share * map.colours[above][i]));
    return colour;
}

bool is_dark(std::array<unsigned char, 3> colour) {
    return 299 * colour[0] + 587 * colour[1] + 114 * colour[2] < 550 * 255;
}

double ColourRange::position(double value) const {
    if (!(high > low)) return 0.5;
    if (!logarithmic) return (value - low) / (high - low);
    return value > 0 ? std::log(value / low) / std::log(high / low) : 0;
}

double ColourRange::value(double position) const {
    return logarithmic ? low * std::pow(high / low, position) : low + position * (high - low);
}

ColourRange range_of(std::span<const double> values) {
    if (const auto all = finite_range(values)) return {all->first, all->second};
    ColourRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    }
    return range.low <= range.high ? range : ColourRange{};
}

} // namespace gaspard
