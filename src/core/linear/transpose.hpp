// Out-of-place transposition, so that operators along x can be applied as operators along y.
#pragma once

#include <cstddef>

namespace gaspard {

/// out (columns x rows) = in^T, in (rows x columns); row-major with strides `in_stride` and `out_stride`.
void transpose(const double* in, std::size_t in_stride, double* out, std::size_t out_stride, std::size_t rows,
               std::size_t columns);

} // namespace gaspard
