#include "core/base/short_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace gaspard {

namespace {

std::string raised(int number) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(number))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

/// Removes trailing zeros after a decimal point.
void strip_zeros(std::string& text) {
    if (text.find('.') == std::string::npos) return;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
}

std::string digits_of(double value, std::chars_format how, int precision) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, how, precision);
    return {buffer.data(), end.ptr};
}

} // namespace

std::string power_of_ten(int exponent) { return "10" + raised(exponent); }

std::string short_number(double value, int digits) {
    if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : value > 0 ? "∞" : "−∞";
    if (value == 0) return "0";
    std::string text = digits_of(value, std::chars_format::scientific, digits - 1);
    const std::size_t e = text.find('e');
    const int exponent = std::stoi(text.substr(e + 1));
    if (exponent >= -3 && exponent < std::max(digits, 5)) {
        text = digits_of(value, std::chars_format::fixed, std::max(0, digits - 1 - exponent));
        strip_zeros(text);
    } else {
        text.resize(e);
        strip_zeros(text);
        text = (text == "1" ? "" : text == "-1" ? "-" : text + "×") + power_of_ten(exponent);
    }
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

std::string exact_number(double value) {
    if (std::isnan(value)) return "NaN";
    if (!std::isfinite(value) || value == 0) return short_number(value);
    std::array<char, 40> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific);
    const auto exponent = std::find(buffer.data(), end.ptr, 'e');
    const auto digits = std::count_if(buffer.data(), exponent, [](char c) { return c >= '0' && c <= '9'; });
    return short_number(value, static_cast<int>(digits));
}

} // namespace gaspard
