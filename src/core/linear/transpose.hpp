// Out-of-place transposition, so that operators along x can run as operators along y.
#pragma once

#include <cstddef>

namespace gaspard {

/// out (columns x rows) = in (rows x columns)^T, both row-major and dense.
void transpose(const double* in, double* out, std::size_t rows, std::size_t columns);

} // namespace gaspard
