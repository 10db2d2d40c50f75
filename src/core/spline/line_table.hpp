// Splines and their derivatives tabulated at fixed points of a line, and the one-dimensional sums of which
// tensor products are made, one direction after the other (sum factorisation).
//
// The sums act on lines of `length` numbers, which run along the other direction and form the inner loops.
#pragma once

#include "core/spline/knots.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace gaspard {

class LineTable {
  public:
    LineTable(const KnotVector& space, std::span<const double> points, int derivatives);

    std::size_t points() const { return first_.size(); }
    std::size_t functions() const { return functions_; }
    std::size_t width() const { return width_; } ///< degree + 1: nonzero functions per point
    std::size_t first(std::size_t point) const { return first_[point]; }
    const double* row(int derivative, std::size_t point) const {
        return &values_[(static_cast<std::size_t>(derivative) * points() + point) * width_];
    }

    /// out = sum over i of the given derivative of B_i at the point times line i of `lines`.
    void combine(int derivative, std::size_t point, const double* lines, std::size_t length,
                 double* out) const;
    /// The same at all points; out has one line per point.
    void combine_all(int derivative, const double* lines, std::size_t length, double* out) const;
    /// Adds scale times the given derivative of B_i at the point times `in` to every line i of `lines`, of
    /// which the first is that of function `from`.
    void scatter(int derivative, std::size_t point, double scale, const double* in, std::size_t length,
                 double* lines, std::size_t from = 0) const;

  private:
    std::size_t functions_, width_;
    std::vector<std::size_t> first_;
    std::vector<double> values_;
};

} // namespace gaspard
