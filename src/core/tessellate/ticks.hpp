// Where an axis or a legend has its marks, and what is written beside them. Pure mathematics.
#pragma once

#include <string>
#include <vector>

namespace gaspard {

struct Tick {
    double value = 0;
    std::string label; ///< empty where there is no room for one, and for minor ticks
    bool major = true;
};

/// Multiples of 1, 2 or 5 times a power of ten within [low, high], at most about `count` of them.
/// Needs low <= high, both finite; equal ones give that one tick.
std::vector<Tick> linear_ticks(double low, double high, int count);

/// Powers of ten within [low, high] as major ticks, at most about `count` of them, and 2 to 9 times each as
/// minor ones where no decade is left out. Where less than one decade is seen, linear ticks. Needs 0 < low <=
/// high.
std::vector<Tick> log_ticks(double low, double high, int count);

/// "0.25", "1.5×10⁻⁵": `digits` significant ones, without trailing zeros.
std::string short_number(double value, int digits = 4);
/// "10⁻⁸"
std::string power_of_ten(int exponent);

} // namespace gaspard
