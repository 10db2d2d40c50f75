// Out-of-place transposition, so that operators along x can run as operators along y.
#pragma once

#include <cstddef>

namespace gaspard {

/// out (columns x rows) = in (rows x columns)^T, both row-major, rows `in_stride` and `out_stride` apart.
void transpose(const double* in, std::size_t in_stride, double* out, std::size_t out_stride, std::size_t rows,
               std::size_t columns);

} // namespace gaspard
