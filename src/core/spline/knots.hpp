// B-splines on an open knot vector over [0, 1]; Bahari, Habbal, Ratnani, Sonnendruecker (2024), section 2.
//
//   B_i^0 = 1 on [t_i, t_i+1), else 0                                                                   (2.3)
//   B_i^p = (x - t_i) / (t_i+p - t_i) B_i^p-1 + (t_i+p+1 - x) / (t_i+p+1 - t_i+1) B_i+1^p-1             (2.4)
//
// The first and the last knot have multiplicity p + 1, so that the splines interpolate at both ends.
#pragma once

#include "core/base/export.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace gaspard GASPARD_API {

inline constexpr int highest_degree = 7;

/// An open knot vector and its degree.
struct KnotVector {
    int degree = 1;            ///< 0 to highest_degree
    std::vector<double> knots; ///< ascending from 0 to 1; multiplicities at most degree + 1

    std::size_t size() const { return knots.size() - static_cast<std::size_t>(degree) - 1; } ///< dimension
    /// The distinct knots, which bound the cells.
    std::vector<double> breaks() const;
    friend bool operator==(const KnotVector&, const KnotVector&) = default;
};

/// Splines with `regularity` (-1 to degree - 1) continuous derivatives at the interior breaks.
KnotVector open_knots(int degree, std::span<const double> breaks, int regularity);
/// Splines of maximal regularity degree - 1 on equal cells.
KnotVector uniform_knots(int degree, std::size_t cells);
/// Whether the invariants of KnotVector hold.
bool is_open(const KnotVector& space);

/// The index of the last basis function that is nonzero at x; those are functions span - degree to span.
/// Outside [0, 1], that of the first or last cell.
std::size_t find_span(const KnotVector& space, double x);
/// Derivatives of orders 0 to `derivatives` of those functions: out[d * (degree + 1) + k] is the d-th
/// derivative of function span - degree + k. Outside [0, 1] the polynomials of the end cells are continued.
void basis_functions(const KnotVector& space, std::size_t span, double x, int derivatives,
                     std::span<double> out);

/// The Greville abscissae: means of `degree` consecutive knots, which are the coefficients of x (degree >=
/// 1). For degree 0, the midpoints of the cells.
std::vector<double> greville(const KnotVector& space);
/// The coefficients of x^2; degree >= 2.
std::vector<double> square_coefficients(const KnotVector& space);

/// The space of the derivatives: degree and regularity lower by one, (2.11).
KnotVector derivative_space(const KnotVector& space);
/// The coefficients of the derivative in derivative_space(space).
std::vector<double> derivative_coefficients(const KnotVector& space, std::span<const double> coefficients);

/// Whether `fine` contains `coarse`: same degree, and all knots with at least their multiplicity.
bool refines(const KnotVector& fine, const KnotVector& coarse);
/// A dense matrix, by rows.
struct LineMatrix {
    std::size_t rows = 0, columns = 0;
    std::vector<double> entries;
    double& operator()(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
    double operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};
/// The matrix of exact knot insertion (Boehm, 1980): coefficients in `coarse` to coefficients in `fine`,
/// which must refine `coarse`.
LineMatrix insertion(const KnotVector& coarse, const KnotVector& fine);
/// The matrix that takes coefficients in `from` to coefficients in `to`: knot insertion if exact, else
/// interpolation at the Greville points of `to`.
LineMatrix transfer(const KnotVector& from, const KnotVector& to);
/// The matrix that takes values at the Greville points (degree >= 1) to the interpolating coefficients.
LineMatrix interpolation(const KnotVector& space);

} // namespace GASPARD_API
