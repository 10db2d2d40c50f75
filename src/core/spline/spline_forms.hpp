// The two discretisations of Bahari et al. on the parameter square [0, 1]^2: a potential phi, its map Psi,
// and the Poisson problem of each iteration with source g.
//
// Standard form (4.5): phi in S^p (x) S^p,  Psi = grad phi,
//
//   <grad phi, grad v> + shift <phi, v> = <Psi . n, v>_boundary - <g, v>      for all v
//
// Mixed form (6.4): phi in S^p-1 (x) S^p-1,  Psi in (S^p (x) S^p-1, S^p-1 (x) S^p), see (2.13),
//
//   <Psi, v> + <phi, div v> = 0       for all v with v . n = 0,
//   <div Psi, w> = <g, w>             for all w,           Psi . n prescribed on the boundary
//
// In the mixed form Psi follows from phi, so that phi is the only unknown of either form. Sums are factorised
// by direction. In arrays over tensor products x runs fastest.
#pragma once

#include "core/linear/fast_diagonalisation.hpp"
#include "core/spline/line_table.hpp"
#include "core/spline/tensor_space.hpp"

#include <array>
#include <memory>

namespace gaspard {

/// The same line in both directions: S^p on [0, 1] with p + 1 Gauss points per cell.
struct SplineLine {
    explicit SplineLine(KnotVector space);

    KnotVector upper, lower;             ///< S^p and S^p-1
    std::vector<double> points, weights; ///< quadrature
};

/// S^p with two derivatives and S^p-1 with one, tabulated at points of a line; the grid is their tensor
/// product.
struct SplineGrid {
    SplineGrid(const SplineLine& line, std::vector<double> at)
        : points(std::move(at)), upper(line.upper, points, 2), lower(line.lower, points, 1) {}

    std::vector<double> points;
    LineTable upper, lower;
};

/// Psi . n at the quadrature points, up to sign: psi1 at left and right, psi2 at bottom and top.
struct NormalTrace {
    std::vector<double> left, right, bottom, top;
};
/// The trace of the identity, (3.14): 0, 1, 0, 1.
NormalTrace identity_trace(const SplineLine& line);
/// The integral of Psi . n over the boundary.
double flux(const SplineLine& line, const NormalTrace& trace);

/// The fields psi1, psi2, psi1,x, psi1,y, psi2,y. psi2,x equals psi1,y by symmetry; in the mixed form it is
/// replaced by psi1,y, which reproduces the paper's numbers.
inline constexpr std::size_t map_fields = 5;
using FieldRow = std::array<double*, map_fields>;

class SplineForm {
  public:
    virtual ~SplineForm() = default;

    const SplineLine& line() const { return line_; }
    const SplineGrid& quadrature() const { return quadrature_; }
    /// Number of unknowns per direction, and in total.
    std::size_t size() const { return poisson_.size(); }
    std::size_t unknowns() const { return size() * size(); }
    const FastDiagonalisation& poisson() const { return poisson_; }

    struct Workspace {
        FastDiagonalisation::Workspace poisson;
        std::vector<double> first, second;       ///< coefficients of psi1 and psi2, or of phi
        std::array<std::vector<double>, 3> half; ///< after the sum along x: one line per function along y
        std::vector<double> turned, turned_sum;  ///< transposed
        std::vector<double> load;
    };
    Workspace make_workspace() const;

    /// Prepares row() for the map of phi; with `border` zero, for its derivative.
    enum class Border { given, zero };
    virtual void expand(std::span<const double> phi, Border border, const SplineGrid& grid,
                        std::size_t fields, Workspace& workspace) const = 0;
    /// Evaluates the first `fields` fields on row y of the grid given to expand, one value per column.
    void row(const SplineGrid& grid, std::size_t y, std::size_t fields, const FieldRow& out,
             const Workspace& workspace) const;

    /// b = <g, v> for every v of phi's space; load_row takes the rows of g at the quadrature points in any
    /// order.
    void begin_load(Workspace& workspace) const;
    void load_row(std::size_t y, const double* g, Workspace& workspace) const;
    void end_load(std::span<double> b, Workspace& workspace) const;
    /// The contribution of the boundary to the right-hand side.
    std::span<const double> border_load() const { return border_load_; }
    double border_flux() const { return border_flux_; }

    /// The mean of a function of phi's space, and its L2 norm after subtraction of the mean.
    double mean(std::span<const double> phi) const;
    double norm_without_mean(std::span<const double> phi) const;

    /// Psi of phi as splines.
    virtual std::array<SplineFunction, 2> map(std::span<const double> phi) const = 0;
    /// The potential whose map is the identity.
    virtual std::vector<double> identity() const = 0;
    /// The univariate space of phi.
    virtual const KnotVector& space() const = 0;
    virtual const LineTable& tests() const = 0;

  protected:
    /// A field as the index of a sum along x and the sum along y to apply to it.
    struct FieldTerm {
        std::size_t half;
        bool upper;
        int derivative;
    };
    SplineForm(SplineLine line, FastDiagonalisation poisson, std::array<FieldTerm, map_fields> terms)
        : line_(std::move(line)), quadrature_(line_, line_.points), poisson_(std::move(poisson)),
          terms_(terms) {}
    /// half = sum along x over `table` of coefficients with `rows` rows.
    static void sum_along_x(const LineTable& table, int derivative, std::span<const double> coefficients,
                            std::size_t rows, std::vector<double>& half, Workspace& workspace);

    SplineLine line_;
    SplineGrid quadrature_;
    FastDiagonalisation poisson_;
    std::array<FieldTerm, map_fields> terms_;
    std::vector<double> border_load_;
    double border_flux_ = 0;
    std::vector<double> integrals_; ///< integrals of the functions of phi's univariate space
};

/// Requires p >= 2 and splines with a continuous derivative.
std::unique_ptr<SplineForm> make_standard_form(const SplineLine& line, const NormalTrace& trace);
/// Requires p >= 2.
std::unique_ptr<SplineForm> make_mixed_form(const SplineLine& line, const NormalTrace& trace);

} // namespace gaspard
