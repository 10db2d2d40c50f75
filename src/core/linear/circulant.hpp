// Operators on n x n values of a doubly periodic grid that commute with shifts and reflections through a
// point, such as finite elements give on uniform periodic meshes and their inverses:
//
//   out = F^-1 ( s_kl (F in)_kl ),        F the discrete Fourier transform in both directions,
//
// with a real symbol s that is even, s_kl = s_(n-k)(n-l). Exact to rounding.
#pragma once

#include "core/linear/batch_fft.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace gaspard {

/// The two transforms between values on the grid and coefficients, with buffers, so that nothing allocates.
/// Lines are transformed in batches of eight, real lines in pairs, as the parts of one complex sequence.
class CirculantTransform {
  public:
    explicit CirculantTransform(std::size_t n);

    std::size_t size() const { return n_; }
    /// The symbol in the layout of the coefficients, with the factor 1 / n^2 of F^-1. Its arguments are the
    /// phases 2 pi k / n along x and 2 pi l / n along y, 0 <= k <= n / 2 and 0 <= l < n.
    std::vector<double> factors(const std::function<double(double, double)>& symbol) const;
    /// The operator with these factors. `in` and `out`: n^2 numbers, x fastest; they may be the same.
    void apply(std::span<const double> factors, std::span<const double> in, std::span<double> out);

  private:
    void analyse_rows(const double* in);
    void multiply_columns(const double* factors);
    void synthesise_rows(double* out);

    std::size_t n_;
    std::size_t columns_; ///< frequencies in x, n / 2 + 1, rounded up to whole batches
    std::size_t rows_;    ///< n, rounded up to whole pairs of batches
    BatchFft fft_;
    std::vector<double> real_, imaginary_; ///< coefficients in x, columns_ times rows_
    std::vector<double> batch_, scratch_;
};

} // namespace gaspard
