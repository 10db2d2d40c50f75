#include "core/tessellate/contours.hpp"

#include "core/base/check.hpp"
#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

constexpr double rounding = 1e-9;

bool inside(const ColourRange& range, double value) {
    const double place = range.position(value);
    return place > rounding && place < 1 - rounding;
}

/// 10^exponent, exactly rounded, also where it is below 1.
double decade(int exponent) {
    return exponent < 0 ? 1 / std::pow(10.0, -exponent) : std::pow(10.0, exponent);
}

/// k times a step 1, 2 or 5 times 10^exponent, rounded once.
double multiple(double k, int factor, int exponent) {
    return exponent < 0 ? k * factor / std::pow(10.0, -exponent) : k * factor * decade(exponent);
}

/// The multiples of a step inside a range; nullopt if there are more than `most`.
std::optional<std::vector<double>> multiples(const ColourRange& range, int factor, int exponent, int most) {
    const double step = multiple(1, factor, exponent);
    const double first = std::ceil(range.low / step), last = std::floor(range.high / step);
    if (!(last - first <= most + 1.0)) return std::nullopt; // also where the step is beyond double precision
    std::vector<double> found;
    for (int i = 0; i <= last - first; ++i)
        if (const double value = multiple(first + i, factor, exponent); inside(range, value))
            found.push_back(value);
    if (found.size() > static_cast<std::size_t>(most)) return std::nullopt;
    return found;
}

ContourLevels linear_levels(const ColourRange& range, int most) {
    // Of a range of denormal numbers the quotient may be 0.
    const double least =
        std::max((range.high - range.low) / (most + 1.0), std::numeric_limits<double>::min());
    int exponent = static_cast<int>(std::floor(std::log10(least))) - 1;
    for (;; ++exponent)
        for (const int factor : {1, 2, 5})
            if (auto found = multiples(range, factor, exponent, most)) {
                if (found->empty()) return {};
                return {std::move(*found), "every " + short_number(multiple(1, factor, exponent))};
            }
}

/// These multiples of every power of ten in a logarithmic range, or of every so many.
std::vector<double> decade_levels(const ColourRange& range, std::span<const int> factors, int every) {
    const int first = static_cast<int>(std::floor(std::log10(range.low))),
              last = static_cast<int>(std::ceil(std::log10(range.high)));
    std::vector<double> found;
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % every != 0) continue;
        for (const int factor : factors)
            if (const double value = multiple(1, factor, exponent); inside(range, value))
                found.push_back(value);
    }
    return found;
}

ContourLevels logarithmic_levels(const ColourRange& range, int most) {
    const auto fits = [most](const std::vector<double>& found) {
        return found.size() <= static_cast<std::size_t>(most);
    };
    static constexpr std::array nine = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    static constexpr std::array three = {1, 2, 5};
    static constexpr std::array one = {1};
    if (auto found = decade_levels(range, nine, 1); fits(found))
        return {std::move(found), "at 1, 2, ..., 10"};
    if (auto found = decade_levels(range, three, 1); fits(found)) return {std::move(found), "at 1, 2, 5, 10"};
    for (int ten = 1;; ten *= 10)
        for (const int factor : {1, 2, 5}) {
            auto found = decade_levels(range, one, factor * ten);
            if (!fits(found)) continue;
            if (found.empty()) return {};
            const int every = factor * ten;
            return {std::move(found),
                    every == 1 ? "every decade" : "every " + std::to_string(every) + " decades"};
        }
}

double value_span(std::span<const double> values) {
    const ColourRange range = range_of(values);
    return range.high - range.low;
}

/// Where the line crosses the edge between two points; the same for both directions.
ContourPoint crossing(std::uint32_t a, std::uint32_t b, std::span<const double> values, double level) {
    if (b < a) std::swap(a, b);
    const double t = (level - values[a]) / (values[b] - values[a]);
    return {a, b, std::clamp(t, 0.0, 1.0)};
}

} // namespace

ContourLevels contour_levels(const ColourRange& range, int most) {
    if (most <= 0 || !(range.low < range.high) || !std::isfinite(range.high - range.low)) return {};
    const bool decades = range.logarithmic && range.high >= 10 * range.low;
    return decades ? logarithmic_levels(range, most) : linear_levels(range, most);
}

std::vector<ContourSegment> contour_lines(const Tessellation& tessellation, std::span<const double> values,
                                          std::span<const double> levels) {
    GASPARD_CHECK(values.size() == tessellation.point_count);
    std::vector<ContourSegment> segments;
    if (levels.empty()) return segments;
    const double tolerance = rounding * value_span(values);
    const auto& corners = tessellation.triangles;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::array<std::uint32_t, 3> p = {corners[i], corners[i + 1], corners[i + 2]};
        const auto [low, high] = std::minmax({values[p[0]], values[p[1]], values[p[2]]});
        if (!std::isfinite(values[p[0]] + values[p[1]] + values[p[2]])) continue;
        // A corner is above a level unless it is below it by more than rounding.
        const auto above = [&](std::size_t k, double level) { return values[p[k % 3]] >= level - tolerance; };
        const auto first = std::upper_bound(levels.begin(), levels.end(), low + tolerance);
        for (auto level = first; level != levels.end() && *level <= high + tolerance; ++level)
            for (std::size_t k = 0; k < 3; ++k) { // the corner that is alone on its side
                const bool side = above(k, *level);
                if (above(k + 1, *level) == side || above(k + 2, *level) == side) continue;
                if (side && values[p[k]] <= *level + tolerance) continue; // touches the line in one point
                segments.push_back({crossing(p[k], p[(k + 1) % 3], values, *level),
                                    crossing(p[k], p[(k + 2) % 3], values, *level),
                                    static_cast<std::uint32_t>(level - levels.begin()),
                                    static_cast<std::uint32_t>(i / 3)});
            }
    }
    return segments;
}

} // namespace gaspard
