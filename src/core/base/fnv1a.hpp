// The hash of Fowler, Noll and Vo (FNV-1a) of bytes.
#pragma once

#include <cstdint>
#include <string_view>

namespace gaspard {

inline constexpr std::uint64_t fnv1a_start = 0xcbf29ce484222325;

/// `hash`: of the bytes before, to continue with.
inline std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = fnv1a_start) {
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    return hash;
}

} // namespace gaspard
