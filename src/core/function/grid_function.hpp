// A function given by values f_i at the points of a regular grid of a chart:
//
//   u(s) = sum over i of c_i B(t - i),      t = (s - s_0) / h,      u(s_i) = f_i
//
// with tensor products of cubic B-splines B (Unser, Aldroubi, Eden, 1991). u is twice continuously
// differentiable, its error is O(h^4), that of its gradient O(h^3). Across the poles of the sphere u goes on
// along the opposite meridian; at the poles itself its gradient is exact to O(h^3) only.
#pragma once

#include "core/function/grid.hpp"
#include "core/function/scalar_function.hpp"

#include <span>
#include <vector>

namespace gaspard {

/// NaN, as its gradient is, where a coordinate is not finite.
class GridFunction final : public ScalarFunction {
  public:
    /// `values`: grid.size() finite numbers. Those of the rows of the poles are replaced by their mean.
    GridFunction(Grid grid, std::span<const double> values);

    void values(const Points& x, std::span<double> values) const override;
    void gradients(const Points& x, Points& gradients) const override;
    /// The same at coordinates of the chart; `derivatives` are with respect to these.
    void values_at(const Points& s, std::span<double> values) const;
    void derivatives_at(const Points& s, Points& derivatives) const;

    const Grid& grid() const { return grid_; }

  private:
    template <std::size_t dimension, bool derivatives>
    void evaluate(const Points& s, double* values, Points* gradients) const;
    void evaluate(const Points& s, double* values, Points* gradients) const;

    struct Line { ///< one direction of the coefficients
        double origin = 0, inverse_spacing = 0;
        double count = 1;         ///< of points
        double low = 0, high = 0; ///< the ends of the direction, in units of t
        GridEnds ends = GridEnds::free;
        std::size_t stride = 0; ///< between coefficients
    };
    Grid grid_;
    std::vector<Line> lines_;
    std::vector<double> coefficients_; ///< with two more at each end of every direction
};

} // namespace gaspard
