#include "core/tessellate/ticks.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

std::string fixed(double value, int decimals) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, decimals);
    return {buffer.data(), end.ptr};
}

/// A label with as many digits as distinguish neighbouring ticks; the same number for all ticks of an axis.
std::string tick_label(double value, double step, double largest) {
    if (value == 0) return "0";
    const int last_digit = static_cast<int>(std::floor(std::log10(step) + 1e-9));
    const int first_digit = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
    if (first_digit > 5 || last_digit < -5)
        return short_number(value, std::clamp(first_digit - last_digit + 1, 1, 15));
    std::string text = fixed(value, std::max(0, -last_digit));
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

/// Removes labels of ticks in ascending order that are closer on a logarithmic axis than `distance`, in
/// decades, to the label before.
void thin_labels(std::vector<Tick>& ticks, double distance) {
    double last = -std::numeric_limits<double>::infinity();
    for (Tick& tick : ticks) {
        const double position = std::log10(tick.value);
        if (position - last < distance)
            tick.label.clear();
        else
            last = position;
    }
}

/// 1, 2 and 5 times powers of ten.
std::vector<Tick> round_ticks(double low, double high) {
    std::vector<Tick> ticks;
    for (int exponent = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, exponent) <= high;
         ++exponent)
        for (const double multiple : {1.0, 2.0, 5.0})
            if (const double value = multiple * std::pow(10.0, exponent); low <= value && value <= high)
                ticks.push_back({value, short_number(value), true});
    return ticks;
}

} // namespace

/// Where labels would have many digits, of which only the last differ: the roundest is written in full, the
/// others by what they are more or less.
static void label_by_difference(std::vector<Tick>& ticks, double first, double step, int digits) {
    const auto zeros = [first](std::size_t i) {
        int count = 0;
        double k = first + static_cast<double>(i);
        if (k == 0) return 400;
        for (; std::fmod(k, 10) == 0; k /= 10) ++count;
        return count;
    };
    std::size_t roundest = 0;
    for (std::size_t i = 1; i < ticks.size(); ++i)
        if (zeros(i) > zeros(roundest)) roundest = i;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const double more = (static_cast<double>(i) - static_cast<double>(roundest)) * step;
        if (i == roundest)
            ticks[i].label = short_number(ticks[i].value, std::clamp(digits, 1, 17));
        else
            ticks[i].label = (more > 0 ? "+" : "") + short_number(more, 2);
    }
}

std::vector<Tick> linear_ticks(double low, double high, int count) {
    GASPARD_CHECK(low <= high && std::isfinite(low) && std::isfinite(high));
    const double span = high - low;
    // Values that differ only by rounding count as one.
    if (!(span > 1e-13 * std::max(std::abs(low), std::abs(high)))) return {{low, short_number(low), true}};
    const double raw = span / std::max(count, 1);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (const double multiple : {1.0, 2.0, 5.0})
        if (multiple * power >= 0.75 * raw) {
            step = multiple * power;
            break;
        }
    const double largest = std::max(std::abs(low), std::abs(high));
    std::vector<Tick> ticks;
    const double first = std::ceil(low / step - 1e-9);
    for (double k = first; k * step <= high + 1e-9 * step; ++k) {
        const double value = k * step;
        ticks.push_back({value, tick_label(value, step, largest), true});
    }
    constexpr int many = 5;
    const int digits =
        static_cast<int>(std::floor(std::log10(largest) + 1e-9) - std::floor(std::log10(step) + 1e-9)) + 1;
    if (digits > many && !ticks.empty()) label_by_difference(ticks, first, step, digits);
    return ticks;
}

std::vector<Tick> log_ticks(double low, double high, int count) {
    GASPARD_CHECK(0 < low && low <= high && std::isfinite(high));
    const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    if (last <= first) {
        std::vector<Tick> ticks = high / low > 10 ? round_ticks(low, high) : linear_ticks(low, high, count);
        std::erase_if(ticks, [](const Tick& tick) { return tick.value <= 0; });
        thin_labels(ticks, 0.6 * std::log10(high / low) / std::max(count, 1));
        return ticks;
    }
    const int stride =
        std::max(1, static_cast<int>(std::ceil(static_cast<double>(last - first + 1) / std::max(count, 1))));
    std::vector<Tick> ticks;
    for (int exponent = first - 1; exponent <= last; ++exponent) {
        const double decade = std::pow(10.0, exponent);
        // Multiples of the stride counted from 10^0, so that labels stay put while the axis grows.
        if (exponent >= first && exponent % stride == 0)
            ticks.push_back({decade, power_of_ten(exponent), true});
        if (exponent >= first && exponent % stride != 0) ticks.push_back({decade, "", true});
        for (int k = 2; k < 10 && stride == 1; ++k)
            if (k * decade >= low && k * decade <= high) ticks.push_back({k * decade, "", false});
    }
    return ticks;
}

} // namespace gaspard
