#include "core/linear/transpose.hpp"

#include <algorithm>

namespace gaspard {

namespace {

constexpr std::size_t tile = 8; // a cache line of doubles

void transpose_tile(const double* __restrict in, std::size_t in_stride, double* __restrict out,
                    std::size_t out_stride) {
    for (std::size_t c = 0; c < tile; ++c)
        for (std::size_t r = 0; r < tile; ++r) out[c * out_stride + r] = in[r * in_stride + c];
}

} // namespace

void transpose(const double* in, std::size_t in_stride, double* out, std::size_t out_stride, std::size_t rows,
               std::size_t columns) {
    for (std::size_t r = 0; r < rows; r += tile)
        for (std::size_t c = 0; c < columns; c += tile) {
            const double* from = in + r * in_stride + c;
            double* to = out + c * out_stride + r;
            if (r + tile <= rows && c + tile <= columns) {
                transpose_tile(from, in_stride, to, out_stride);
                continue;
            }
            for (std::size_t i = 0; i < std::min(tile, columns - c); ++i)
                for (std::size_t j = 0; j < std::min(tile, rows - r); ++j)
                    to[i * out_stride + j] = from[j * in_stride + i];
        }
}

} // namespace gaspard
