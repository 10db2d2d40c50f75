// From values on a grid to the coefficients of the cubic spline through them, one direction at a time:
//
//   (c_(i-1) + 4 c_i + c_(i+1)) / 6 = f_i
//
// with the conditions of GridEnds. Free ends: the third derivative is continuous at the second point, which
// gives c_1 = (8 f_1 - f_0 - f_2) / 6.
#pragma once

#include "core/function/grid.hpp"

#include <cstddef>

namespace gaspard {

/// One direction of an array: `count` rows of `columns` numbers, row i at i * stride.
struct GridRows {
    double* first = nullptr; ///< row 0; there are two more rows before it and after the last
    std::size_t count = 0, columns = 0, stride = 0;
    double* row(std::ptrdiff_t i) const { return first + i * static_cast<std::ptrdiff_t>(stride); }
};

/// Overwrites rows 0 .. count - 1 by coefficients; not for poles.
void filter_rows(const GridRows& rows, const GridDirection& direction);
/// The two rows before and after them; not for poles.
void extend_rows(const GridRows& rows, const GridDirection& direction);

/// Both for the latitudes (rows) of a grid on the sphere; the columns are the longitudes, an even number.
void filter_poles(const GridRows& rows);
void extend_poles(const GridRows& rows);

} // namespace gaspard
