#include "core/base/number_text.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace gaspard {

namespace {

constexpr std::string_view blanks = " \t\n\r\f\v";

std::optional<double> parse_decimal(std::string_view word) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) return std::nullopt;
    }
    constexpr std::size_t longest = 300; // then only an exponent can make a number too large or too small
    if (word.empty() || word.size() > longest) return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range)
        return word.find("e-") != word.npos || word.find("E-") != word.npos ? std::optional(0.0)
                                                                            : std::nullopt;
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string shortened(std::string_view word) {
    constexpr std::size_t most = 40;
    return word.size() <= most ? std::string(word) : std::string(word.substr(0, most)) + "...";
}

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

template <class Number, class Bits>
std::vector<double> numbers_in(std::string_view bytes, const std::string& what) {
    if (bytes.size() % sizeof(Number) != 0)
        throw InputError(what + " has " + std::to_string(bytes.size()) + " bytes, not a multiple of " +
                         std::to_string(sizeof(Number)));
    std::vector<double> all;
    all.reserve(bytes.size() / sizeof(Number));
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(Number)) {
        std::uint64_t bits = 0;
        for (std::size_t i = sizeof(Number); i-- > 0;)
            bits = bits << 8 | static_cast<unsigned char>(bytes[at + i]);
        const auto value = static_cast<double>(std::bit_cast<Number>(static_cast<Bits>(bits)));
        if (!std::isfinite(value)) throw InputError(what + " has a number that is not finite");
        all.push_back(value);
    }
    return all;
}

struct NumberType {
    std::string_view name;
    std::vector<double> (*read)(std::string_view bytes, const std::string& what);
};

constexpr std::array<NumberType, 8> number_types = {{
    {"float32", &numbers_in<float, std::uint32_t>},
    {"float64", &numbers_in<double, std::uint64_t>},
    {"int16", &numbers_in<std::int16_t, std::uint16_t>},
    {"int32", &numbers_in<std::int32_t, std::uint32_t>},
    {"int64", &numbers_in<std::int64_t, std::uint64_t>},
    {"uint16", &numbers_in<std::uint16_t, std::uint16_t>},
    {"uint32", &numbers_in<std::uint32_t, std::uint32_t>},
    {"uint64", &numbers_in<std::uint64_t, std::uint64_t>},
}};

} // namespace

std::optional<double> parse_number(std::string_view word) {
    const auto slash = word.find('/');
    if (slash == std::string_view::npos) return parse_decimal(word);
    const auto above = parse_decimal(word.substr(0, slash)), below = parse_decimal(word.substr(slash + 1));
    if (!above || !below || !std::isfinite(*above / *below)) return std::nullopt;
    return *above / *below;
}

std::vector<double> parse_numbers(std::string_view text, const std::string& what) {
    std::vector<double> all;
    while (true) {
        const auto begin = text.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return all;
        text.remove_prefix(begin);
        const std::string_view word = text.substr(0, std::min(text.find_first_of(blanks), text.size()));
        const auto number = parse_number(word);
        if (!number) throw InputError(what + " must be a list of numbers, but has '" + shortened(word) + "'");
        all.push_back(*number);
        text.remove_prefix(word.size());
    }
}

std::optional<std::string> decode_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t group = 0;
    std::size_t digits = 0, padding = 0;
    for (const char c : text) {
        if (blanks.find(c) != std::string_view::npos) continue;
        const int digit = base64_digit(c);
        padding += c == '=' ? 1 : 0;
        if (c != '=' && (digit < 0 || padding > 0)) return std::nullopt;
        group = group << 6 | static_cast<std::uint32_t>(std::max(digit, 0));
        if (++digits % 4 != 0) continue;
        for (const int shift : {16, 8, 0}) bytes += static_cast<char>(group >> shift & 255U);
        group = 0;
    }
    if (digits % 4 != 0 || padding > 2) return std::nullopt;
    return bytes.substr(0, bytes.size() - padding);
}

std::vector<double> decode_numbers(std::string_view base64, std::string_view type, const std::string& what) {
    const auto known = std::find_if(number_types.begin(), number_types.end(),
                                    [&](const NumberType& one) { return one.name == type; });
    if (known == number_types.end())
        throw InputError(what + " has numbers of the unknown type '" + std::string(type) + "'");
    const auto bytes = decode_base64(base64);
    if (!bytes) throw InputError(what + " is not valid base64");
    return known->read(*bytes, what);
}

} // namespace gaspard
