// Eigen for the slow references.
#pragma once

// With -march=native GCC 12 takes the registers that its own AVX-512 header leaves undefined on purpose for
// mistakes of ours, wherever Eigen is inlined (GCC bug 105593).
#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <Eigen/Dense>
#include <Eigen/Sparse>
#pragma GCC diagnostic pop
