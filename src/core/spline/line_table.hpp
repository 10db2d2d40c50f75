// Splines and their derivatives at fixed points of a line, and the sums over them, which are all that tensor
// products need: one direction after the other (sum factorisation), never the product of both.
//
// Lines of numbers run along the other direction, `length` of them in a row, so that the inner loops do.
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
    std::size_t width() const { return width_; } ///< degree + 1 functions may differ from zero at a point
    std::size_t first(std::size_t point) const { return first_[point]; }
    const double* row(int derivative, std::size_t point) const {
        return &values_[(static_cast<std::size_t>(derivative) * points() + point) * width_];
    }

    /// out = sum over the functions i of the derivative of B_i at a point times line i of `lines`.
    void combine(int derivative, std::size_t point, const double* lines, std::size_t length,
                 double* out) const;
    /// The same at all points: out has a line per point.
    void combine_all(int derivative, const double* lines, std::size_t length, double* out) const;
    /// Adds to line i of `lines` the derivative of B_i at a point times `in`.
    void scatter(int derivative, std::size_t point, double scale, const double* in, std::size_t length,
                 double* lines) const;

  private:
    std::size_t functions_, width_;
    std::vector<std::size_t> first_;
    std::vector<double> values_;
};

} // namespace gaspard
