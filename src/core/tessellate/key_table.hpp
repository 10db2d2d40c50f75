// Numbers by keys of 64 bits, for hundreds of thousands of look-ups per frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaspard {

class KeyTable {
  public:
    static constexpr std::uint32_t missing = 0xffffffff;

    KeyTable() { clear(); }
    void clear() {
        slots_.assign(first_size, {});
        used_ = 0;
    }
    /// The number of a key; `missing` until it is set. Valid until the next call.
    std::uint32_t& operator[](std::uint64_t key) {
        if (2 * used_ >= slots_.size()) grow();
        Slot& slot = find(key);
        if (slot.key == free) slot.key = key, ++used_;
        return slot.number;
    }

  private:
    static constexpr std::uint64_t free = ~std::uint64_t{0}; ///< no key
    static constexpr std::size_t first_size = 1024;          ///< a power of two
    struct Slot {
        std::uint64_t key = free;
        std::uint32_t number = missing;
    };

    Slot& find(std::uint64_t key) {
        const std::size_t mask = slots_.size() - 1;
        std::uint64_t hash = key * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 32;
        auto at = static_cast<std::size_t>(hash) & mask;
        while (slots_[at].key != key && slots_[at].key != free) at = (at + 1) & mask;
        return slots_[at];
    }
    void grow() {
        std::vector<Slot> before(4 * slots_.size());
        before.swap(slots_);
        for (const Slot& slot : before)
            if (slot.key != free) find(slot.key) = slot;
    }

    std::vector<Slot> slots_;
    std::size_t used_ = 0;
};

} // namespace gaspard
