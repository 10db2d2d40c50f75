// The eigenvectors of quadratic finite elements on a line of n equal cells, applied by FFT:
//
//   K s = lambda M s,   S^T M S = I,   S^T K S = diag(lambda)                    (fast diagonalisation)
//
// K stiffness, M mass, on [0,1] closed to a ring (2 n unknowns) or with natural ends (2 n + 1 unknowns; the
// even functions of the ring of length 2). Unknown 2 c is vertex c, unknown 2 c + 1 the middle of cell c. An
// eigenvector is a cos(2 pi k c / P) at the vertices and b cos(2 pi k (c + 1/2) / P) at the middles, P cells
// in the ring, or the same with sines; (a, b) solves a 2 x 2 problem. Vertices and middles travel as one
// complex sequence.
#pragma once

#include "core/linear/batch_fft.hpp"

#include <cstddef>
#include <vector>

namespace gaspard {

class LineSpectrum {
  public:
    /// Lines are transformed in batches of eight, side by side.
    static constexpr std::size_t lanes = BatchFft::lanes;

    LineSpectrum(std::size_t cells, bool periodic);

    std::size_t cells() const { return cells_; }
    bool periodic() const { return periodic_; }
    std::size_t size() const { return eigenvalues_.size(); }
    /// lambda, in the order of the coefficients; the first is 0, its eigenvector constant.
    const std::vector<double>& eigenvalues() const { return eigenvalues_; }

    /// One caller's buffers, so that transforms allocate nothing; not to be shared by threads.
    struct Workspace {
        std::vector<double> time, frequency;
    };
    Workspace make_workspace() const;
    /// c = S^T b. Row i of b (its unknown i) has eight values, one a line; rows are `stride` apart. c has
    /// rows of eight without gaps. In place is allowed.
    void analyse(const double* b, std::size_t stride, double* c, Workspace& workspace) const;
    /// u = S c, with the rows of u `stride` apart.
    void synthesise(const double* c, double* u, std::size_t stride, Workspace& workspace) const;

  private:
    struct Mode { ///< the two branches of one frequency, scaled to unit mass
        double vertex[2];
        double middle_cosine[2], middle_sine[2]; ///< times exp(i pi k / P): half a cell further on
    };
    void split(const double* frequency, double* c, double half) const;
    void merge(const double* c, double* frequency) const;

    std::size_t cells_, ring_; ///< n, and P
    bool periodic_;
    BatchFft fft_;
    std::vector<Mode> modes_; ///< frequencies 0 .. floor(P / 2)
    std::vector<double> eigenvalues_;
};

} // namespace gaspard
