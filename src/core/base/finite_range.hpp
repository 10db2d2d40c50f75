// Minimum and maximum of an array, with a check that all values are finite.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace gaspard {

/// (minimum, maximum) of the values; nullopt if there are none or if any is infinite or NaN.
inline std::optional<std::pair<double, double>> finite_range(std::span<const double> values) {
    constexpr std::size_t lanes = 8; // independent accumulators, to hide the latency of comparisons
    std::array<double, lanes> low, high, strange{};
    low.fill(std::numeric_limits<double>::infinity()), high.fill(-std::numeric_limits<double>::infinity());
    const auto see = [&](std::size_t lane, double value) {
        low[lane] = value < low[lane] ? value : low[lane];
        high[lane] = value > high[lane] ? value : high[lane];
        strange[lane] += value - value; // inf - inf is NaN
    };
    std::size_t i = 0;
    for (; i + lanes <= values.size(); i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) see(lane, values[i + lane]);
    for (; i < values.size(); ++i) see(i % lanes, values[i]);
    for (std::size_t lane = 1; lane < lanes; ++lane) {
        low[0] = low[lane] < low[0] ? low[lane] : low[0];
        high[0] = high[lane] > high[0] ? high[lane] : high[0];
        strange[0] += strange[lane];
    }
    if (values.empty() || strange[0] != 0) return std::nullopt;
    return std::pair(low[0], high[0]);
}

} // namespace gaspard
