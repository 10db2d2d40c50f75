// B-splines on an open knot vector over [0, 1]: Bahari, Habbal, Ratnani, Sonnendruecker (2024), section 2.
//
//   B_i^0 = 1 on [t_i, t_i+1), else 0                                                                   (2.3)
//   B_i^p = (x - t_i) / (t_i+p - t_i) B_i^p-1 + (t_i+p+1 - x) / (t_i+p+1 - t_i+1) B_i+1^p-1             (2.4)
//
// The first and the last knot have multiplicity p + 1: the first and the last function are 1 at the ends.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gaspard {

inline constexpr int highest_degree = 7;

/// An open knot vector with its degree.
struct KnotVector {
    int degree = 1;            ///< 0 to highest_degree
    std::vector<double> knots; ///< ascending from 0 to 1, none more than degree + 1 times

    std::size_t size() const { return knots.size() - static_cast<std::size_t>(degree) - 1; } ///< functions
    /// The different knots: the ends of the cells.
    std::vector<double> breaks() const;
    friend bool operator==(const KnotVector&, const KnotVector&) = default;
};

/// Splines with `regularity` continuous derivatives (-1 to degree - 1) at the inner breaks.
KnotVector open_knots(int degree, std::span<const double> breaks, int regularity);
/// The smoothest splines, of C^(degree - 1), on equal cells.
KnotVector uniform_knots(int degree, std::size_t cells);
/// Whether the promises of KnotVector hold.
bool is_open(const KnotVector& space);

/// The number of the last function of those that may differ from zero at x: functions span - degree to span.
/// Beyond the ends, of the first and the last cell.
std::size_t find_span(const KnotVector& space, double x);
/// Derivatives 0 to `derivatives` of those functions: out[d * (degree + 1) + k] is the d-th of function
/// span - degree + k. Beyond [0, 1] the polynomials of the end cells go on.
void basis_functions(const KnotVector& space, std::size_t span, double x, int derivatives,
                     std::span<double> out);

/// The means of degree knots each: the coefficients of the identity (degree >= 1). For degree 0, the middles.
std::vector<double> greville(const KnotVector& space);
/// The coefficients of x^2, degree >= 2.
std::vector<double> square_coefficients(const KnotVector& space);

/// The derivatives of the splines: degree and regularity one lower, (2.11).
KnotVector derivative_space(const KnotVector& space);
/// Of coefficients in `space`, those of the derivative in derivative_space(space).
std::vector<double> derivative_coefficients(const KnotVector& space, std::span<const double> coefficients);

/// Whether every spline of `coarse` is one of `fine`: same degree, and all knots there.
bool refines(const KnotVector& fine, const KnotVector& coarse);
/// A matrix, `rows` x `columns`, row after row.
struct LineMatrix {
    std::size_t rows = 0, columns = 0;
    std::vector<double> entries;
    double& operator()(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
    double operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};
/// Exact knot insertion (Boehm, 1980): coefficients in `fine`, which refines `coarse`, of the same splines.
LineMatrix insertion(const KnotVector& coarse, const KnotVector& fine);
/// Coefficients in `to` of splines in `from`: by insertion where that is exact, else those that agree at the
/// Greville points of `to`.
LineMatrix transfer(const KnotVector& from, const KnotVector& to);
/// Of values at the Greville points of a space (degree >= 1), the coefficients of the splines that have them.
LineMatrix interpolation(const KnotVector& space);

} // namespace gaspard
