// Ticks of axes and legends, and their labels.
#pragma once

#include "core/base/short_number.hpp"

#include <string>
#include <vector>

namespace gaspard {

struct Tick {
    double value = 0;
    std::string label; ///< empty for minor ticks and where labels would be too dense
    bool major = true;
};

/// Multiples of 1, 2 or 5 times a power of ten in [low, high], at most about `count` of them. Requires finite
/// low <= high; if equal, returns that one tick. Where labels would have more than 5 digits, one is written
/// in full and the others as differences from it: "−2×10⁻¹³", "1", "+2×10⁻¹³".
std::vector<Tick> linear_ticks(double low, double high, int count);

/// Powers of ten in [low, high] as major ticks, at most about `count`, and 2 to 9 times each as minor ticks
/// if no decade is skipped. For ranges with at most one power of ten, linear ticks; these crowd together
/// towards the upper end of a logarithmic axis, so that some have no label: two labels are at least 0.6/count
/// of the axis apart. Requires 0 < low <= high.
std::vector<Tick> log_ticks(double low, double high, int count);

} // namespace gaspard
