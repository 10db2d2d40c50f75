// Fourier transforms of batches of eight sequences of equal length, interleaved so that one vector
// instruction handles all eight, whatever their length.
//
//   out_k = sum over j of in_j exp(-2 pi i j k / n)          (backward: exp(+2 pi i j k / n), unscaled)
//
// Layout of a batch: 2 n rows of eight numbers; row 2 j holds the real parts of element j, row 2 j + 1 the
// imaginary parts.
#pragma once

#include <cstddef>
#include <vector>

namespace gaspard {

class BatchFft {
  public:
    static constexpr std::size_t lanes = 8;

    explicit BatchFft(std::size_t n);

    std::size_t length() const { return n_; }
    /// Transforms `data` and returns a pointer to the result, which is either `data` or `scratch`. Both have
    /// 2 n lanes numbers; both are overwritten.
    double* forward(double* data, double* scratch) const { return transform(data, scratch, 0, lanes); }
    double* backward(double* data, double* scratch) const { return transform(data, scratch, lanes, 0); }

  private:
    struct Pass { ///< one factor of n (Stockham): `groups` twiddle factors, each for `stride` elements
        std::size_t radix, groups, stride, first_twiddle;
    };
    double* transform(double* data, double* scratch, std::size_t real, std::size_t imaginary) const;

    std::size_t n_;
    std::vector<Pass> passes_;
    std::vector<double> twiddles_; ///< cosine, sine; for each pass and group the powers 1, 2, ...
    std::vector<double> roots_;    ///< roots of unity of the passes with radix > 5
};

} // namespace gaspard
