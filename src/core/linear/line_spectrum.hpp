// The eigenvectors of quadratic finite elements on a line of n equal cells, applied by FFT:
//
//   K S = M S diag(lambda),   S^T M S = I,   S^T K S = diag(lambda)              (fast diagonalisation)
//
// K is the stiffness and M the mass matrix on [0, 1]: periodic (2 n unknowns), or with natural boundary
// conditions (2 n + 1 unknowns; the even functions on the periodic line of length 2). Unknown 2 c is vertex
// c, unknown 2 c + 1 the midpoint of cell c. With P cells in the period, an eigenvector is
//
//   a cos(2 pi k c / P) at the vertices,   b cos(2 pi k (c + 1/2) / P) at the midpoints,
//
// or the same with sines, where (a, b) solves a 2 x 2 eigenproblem. Vertices and midpoints are transformed
// together as the real and imaginary parts of one complex sequence.
#pragma once

#include "core/linear/batch_fft.hpp"

#include <cstddef>
#include <vector>

namespace gaspard {

class LineSpectrum {
  public:
    /// Lines are transformed in batches of eight.
    static constexpr std::size_t lanes = BatchFft::lanes;

    LineSpectrum(std::size_t cells, bool periodic);

    std::size_t cells() const { return cells_; }
    bool periodic() const { return periodic_; }
    std::size_t size() const { return eigenvalues_.size(); }
    /// lambda, in the order of the coefficients; the first is 0 and its eigenvector is constant.
    const std::vector<double>& eigenvalues() const { return eigenvalues_; }

    /// Buffers, so that transforms do not allocate; one per thread.
    struct Workspace {
        std::vector<double> time, frequency;
    };
    Workspace make_workspace() const;
    /// c = S^T b for eight lines. Row i of b holds unknown i of the eight lines; rows are `stride` apart. The
    /// rows of c are contiguous. c may be b.
    void analyse(const double* b, std::size_t stride, double* c, Workspace& workspace) const;
    /// u = S c for eight lines, with the rows of u `stride` apart.
    void synthesise(const double* c, double* u, std::size_t stride, Workspace& workspace) const;

  private:
    struct Mode { ///< both branches of one frequency, normalised to unit mass
        double vertex[2];
        double middle_cosine[2], middle_sine[2]; ///< times exp(i pi k / P), the shift by half a cell
    };
    void split(const double* frequency, double* c, double half) const;
    void merge(const double* c, double* frequency) const;

    std::size_t cells_, ring_; ///< n and P
    bool periodic_;
    BatchFft fft_;
    std::vector<Mode> modes_; ///< frequencies 0 .. floor(P / 2)
    std::vector<double> eigenvalues_;
};

} // namespace gaspard
