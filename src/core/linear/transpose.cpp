#include "core/linear/transpose.hpp"

#include <algorithm>

namespace gaspard {

void transpose(const double* in, double* out, std::size_t rows, std::size_t columns) {
    constexpr std::size_t tile = 16; // two cache lines of doubles on either side
    for (std::size_t r0 = 0; r0 < rows; r0 += tile)
        for (std::size_t c0 = 0; c0 < columns; c0 += tile) {
            const std::size_t r1 = std::min(rows, r0 + tile), c1 = std::min(columns, c0 + tile);
            for (std::size_t r = r0; r < r1; ++r)
                for (std::size_t c = c0; c < c1; ++c) out[c * rows + r] = in[r * columns + c];
        }
}

} // namespace gaspard
