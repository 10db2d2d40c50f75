// Fourier transforms of many sequences at once: eight of equal length stand side by side, so that one
// instruction works on all of them whatever their length.
//
//   out_k = sum over j of in_j exp(-2 pi i j k / n)          (backward: with +, not divided by n)
//
// A batch is 2 n rows of eight numbers: row 2 j holds the real parts of element j, row 2 j + 1 the imaginary
// ones.
#pragma once

#include <cstddef>
#include <vector>

namespace gaspard {

class BatchFft {
  public:
    static constexpr std::size_t lanes = 8;

    explicit BatchFft(std::size_t n);

    std::size_t length() const { return n_; }
    /// Transforms `data` and says where the result stands: in `data` or in `scratch`, which is as large.
    double* forward(double* data, double* scratch) const { return transform(data, scratch, 0, lanes); }
    double* backward(double* data, double* scratch) const { return transform(data, scratch, lanes, 0); }

  private:
    struct Pass { ///< one factor of n (Stockham): `groups` twiddles, each for `stride` elements
        std::size_t radix, groups, stride, first_twiddle;
    };
    double* transform(double* data, double* scratch, std::size_t real, std::size_t imaginary) const;

    std::size_t n_;
    std::vector<Pass> passes_;
    std::vector<double>
        twiddles_;              ///< cosine and sine in turn: of a pass's groups, of each the powers 1, 2, ...
    std::vector<double> roots_; ///< of the passes without a butterfly of their own
};

} // namespace gaspard
