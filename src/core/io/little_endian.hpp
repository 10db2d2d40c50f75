// Numbers as little-endian bytes on every machine.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

namespace gaspard {

template <std::unsigned_integral Unsigned>
void append_little_endian(std::string& bytes, Unsigned value) {
    std::array<char, sizeof value> little;
    for (std::size_t i = 0; i < sizeof value; ++i) little[i] = static_cast<char>((value >> (8 * i)) & 0xffu);
    bytes.append(little.data(), little.size());
}
inline void append_little_endian(std::string& bytes, std::int32_t value) {
    append_little_endian(bytes, static_cast<std::uint32_t>(value));
}
inline void append_little_endian(std::string& bytes, double value) {
    append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
}

} // namespace gaspard
