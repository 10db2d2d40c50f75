// Why adapt? The error of interpolating a function u on a mesh, from its values at the corners of the cells:
//
//   e = u - Iu,   Iu linear on triangles and lines, bilinear on quadrilaterals, trilinear on hexahedra
//
//   L2 = ( integral of e^2 )^(1/2)    maximum = max |e|    H1 = ( integral of |grad e|^2 )^(1/2)
//
// For smooth u, L2 and maximum are O(h^2), H1 is O(h) (Ciarlet, The Finite Element Method for Elliptic
// Problems, section 3.1). On cells of size h(x) in one direction, L2^2 is the integral of h^4 u''^2 / 120 to
// leading order; of all meshes with as many cells, it is smallest where h is proportional to |u''|^(-2/5)
// (Huang and Russell, Adaptive Moving Mesh Methods, chapter 2).
//
// Cells, by where the mesh lies:
//   line, plane, solid   straight cells between the corners: isoparametric Q1, or P1
//   sphere               such cells projected to the sphere from its centre. Their edges are parts of great
//                        circles, so that they cover the sphere; Iu is (bi)linear in the coordinates of the
//                        flat cell, and u is compared with it at the point of the sphere above. grad is the
//                        tangential gradient.
//   surface in space     the curved cells of the mesh; Iu is (bi)linear in their reference coordinates, grad
//                        the tangential gradient. Points lie off the surface as far as the cells do.
//
// Integrals are Gauss sums (3 points per direction) over parts of a cell, which are halved until the sum over
// the halves differs from that over the whole by no more than `tolerance`. The maximum is that over all these
// points and a grid of 5 points per direction, with a parabola through the largest and its neighbours.
//
// Where a cell folds (its Jacobian is not positive), Iu has several values and its gradient is not bounded.
// Such cells are counted; their L2 error is that of all sheets, their H1 error and that of the mesh are not a
// number.
#pragma once

#include "core/base/export.hpp"
#include "core/base/series.hpp"
#include "core/function/scalar_function.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/space.hpp"

#include <array>
#include <memory>
#include <stop_token>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard GASPARD_API {

enum class ErrorNorm { l2, maximum, h1 };
inline constexpr std::array<ErrorNorm, 3> error_norms{ErrorNorm::l2, ErrorNorm::maximum, ErrorNorm::h1};
std::string_view norm_name(ErrorNorm norm);  ///< "l2", "maximum", "h1": in files
std::string_view norm_label(ErrorNorm norm); ///< "L2", "maximum", "H1": for people

/// The interpolation error of one mesh; 0 where it is rounding alone (below 1e-13 of the largest |u|). Arrays
/// have one entry per ErrorNorm, in the order of error_norms.
struct InterpolationError {
    std::array<double, 3> norm{}; ///< of the whole mesh; NaN if x is not finite, H1 also if cells fold
    /// Of each cell: the square root of its part of the integral, or its maximum.
    std::array<std::vector<double>, 3> cells{};
    /// Estimated error of `norm`, relative to it: what the last halving has changed.
    std::array<double, 3> uncertainty{};
    double measure = 0;               ///< length, area or volume of the cells
    std::size_t tangled_cells = 0;    ///< cells that fold
    std::size_t unresolved_cells = 0; ///< cells where the halving ended before the tolerance was reached

    double of(ErrorNorm which) const { return norm[static_cast<std::size_t>(which)]; }
    const std::vector<double>& of_cells(ErrorNorm which) const {
        return cells[static_cast<std::size_t>(which)];
    }
};

struct InterpolationOptions {
    int threads = 1;         ///< results do not depend on it
    double tolerance = 1e-3; ///< of the squares of L2 and H1, of a cell or, in equal shares, of the mesh
    int halvings = 7;        ///< at most, at least 1
    std::size_t parts = 500; ///< at most as many parts per cell are looked at, on average over 32 cells
    std::stop_token stop{};
};

/// The errors on the uniform and on the adapted mesh, which have the same cells, of one function.
struct InterpolationComparison {
    std::shared_ptr<const InterpolationError> uniform, adapted; ///< nodes at xi, nodes at x; never null
    std::uint64_t version = 0; ///< Snapshot::version of the adapted mesh; 0 without a run

    /// Whether both meshes interpolate u exactly, as they do a constant.
    bool exact() const {
        return uniform->of(ErrorNorm::maximum) == 0 && adapted->of(ErrorNorm::maximum) == 0;
    }
    /// Uniform / adapted: how many times the error has become smaller; 1 where both are zero.
    double ratio(ErrorNorm which) const;
    /// Of each cell; errors below 1e-12 of the largest, rounding in practice, count as equal.
    std::vector<double> cell_ratios(ErrorNorm which) const;
    /// The smallest and the largest error of the cells of both meshes, the range of their common colours.
    std::pair<double, double> range(ErrorNorm which) const;
};

/// The error on the mesh with nodes at x. Throws InputError if u is not finite somewhere, Interrupted if
/// asked to stop.
InterpolationError interpolation_error(const Mesh& mesh, const Points& x, const Space& space,
                                       const ScalarFunction& u, const InterpolationOptions& options = {});

/// Both errors: nodes at xi and at x.
InterpolationComparison compare_interpolation(const Mesh& mesh, const Points& x, const Space& space,
                                              const ScalarFunction& u,
                                              const InterpolationOptions& options = {});

/// The series of a run: l2_error, maximum_error, h1_error of the adapted, l2_error_uniform, ... of the
/// uniform mesh; and their values in the same order.
std::vector<SeriesInfo> interpolation_series();
SeriesValues values_of(const InterpolationComparison& comparison);

} // namespace GASPARD_API
