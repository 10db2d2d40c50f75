// Eigen, for the reference computations.
#pragma once

// With -march=native, GCC 12 reports the deliberately uninitialised registers of its own AVX-512 header as
// errors in code that inlines Eigen (GCC bug 105593).
#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <Eigen/Dense>
#include <Eigen/Sparse>
#pragma GCC diagnostic pop
