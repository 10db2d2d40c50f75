// Reads little-endian numbers from bytes.
#pragma once

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace gaspard {

class LittleEndian {
  public:
    explicit LittleEndian(std::string_view bytes) : bytes_(bytes) {}

    template <class Unsigned>
    Unsigned unsigned_number() {
        if (bytes_.size() < sizeof(Unsigned)) throw std::runtime_error("the bytes end too early");
        std::uint64_t value = 0;
        for (std::size_t i = sizeof(Unsigned); i-- > 0;)
            value = value << 8 | static_cast<unsigned char>(bytes_[i]);
        bytes_.remove_prefix(sizeof(Unsigned));
        return static_cast<Unsigned>(value);
    }
    std::int32_t int32() { return static_cast<std::int32_t>(unsigned_number<std::uint32_t>()); }
    double real() { return std::bit_cast<double>(unsigned_number<std::uint64_t>()); }
    std::string_view rest() const { return bytes_; }

  private:
    std::string_view bytes_;
};

} // namespace gaspard
