// The two discretisations of Bahari et al. on the parameter square [0, 1]^2, as what their iterations need: a
// potential phi, its map Psi, and the Poisson problem whose right-hand side the iteration makes.
//
//   standard (4.5):  phi in S^p (x) S^p,  Psi = grad phi,
//                    <grad phi, grad v> + shift <phi, v> = <Psi . n, v> at the border - <g, v>
//   mixed (6.4):     phi in S^p-1 (x) S^p-1,  Psi in (S^p (x) S^p-1, S^p-1 (x) S^p), (2.13),
//                    <Psi, v> + <phi, div v> = 0 for v without flux,  <div Psi, w> = <g, w>,
//                    Psi . n as given at the border, exactly
//
// In the mixed one Psi follows from phi, so phi is the only unknown of both. Everything is summed one
// direction after the other. Arrays over a product run fastest in x.
#pragma once

#include "core/linear/fast_diagonalisation.hpp"
#include "core/spline/line_table.hpp"

#include <array>
#include <memory>

namespace gaspard {

/// The same line in both directions: S^p on [0, 1], with p + 1 Gauss points per cell.
struct SplineLine {
    explicit SplineLine(KnotVector space);

    KnotVector upper, lower;             ///< S^p and S^p-1
    std::vector<double> points, weights; ///< of the quadrature
};

/// S^p with two derivatives and S^p-1 with one, at points of the line; the grid is their product.
struct SplineGrid {
    SplineGrid(const SplineLine& line, std::vector<double> at)
        : points(std::move(at)), upper(line.upper, points, 2), lower(line.lower, points, 1) {}

    std::vector<double> points;
    LineTable upper, lower;
};

/// What Psi is across each side, at the quadrature's points: psi1 at left and right, psi2 at bottom and top.
struct NormalTrace {
    std::vector<double> left, right, bottom, top;
};
/// Of the identity, (3.14): 0, 1, 0, 1.
NormalTrace identity_trace(const SplineLine& line);
/// The integral of Psi . n over the border.
double flux(const SplineLine& line, const NormalTrace& trace);

/// psi1, psi2 and the derivatives psi1,x, psi1,y, psi2,y; of psi2,x nothing is asked (symmetry; in the mixed
/// one it is taken to be psi1,y, as the paper's numbers have it).
inline constexpr std::size_t map_fields = 5;
using FieldRow = std::array<double*, map_fields>;

class SplineForm {
  public:
    virtual ~SplineForm() = default;

    const SplineLine& line() const { return line_; }
    const SplineGrid& quadrature() const { return quadrature_; }
    /// Of phi, per direction and in all.
    std::size_t size() const { return poisson_.size(); }
    std::size_t unknowns() const { return size() * size(); }
    const FastDiagonalisation& poisson() const { return poisson_; }

    struct Workspace {
        FastDiagonalisation::Workspace poisson;
        std::vector<double> first, second;       ///< coefficients of psi1 and psi2, or of phi
        std::array<std::vector<double>, 3> half; ///< summed along x: a line per function along y
        std::vector<double> turned, turned_sum;  ///< with lines along the other direction
        std::vector<double> load;
    };
    Workspace make_workspace() const;

    /// Prepares the rows below for the map of phi; with `border` zero, for its derivative.
    enum class Border { given, zero };
    virtual void expand(std::span<const double> phi, Border border, const SplineGrid& grid,
                        std::size_t fields, Workspace& workspace) const = 0;
    /// The first `fields` fields at row y of that grid, which has as many columns as rows.
    void row(const SplineGrid& grid, std::size_t y, std::size_t fields, const FieldRow& out,
             const Workspace& workspace) const;

    /// b = <g, v> for every v of phi's space, from rows of g at the quadrature's points in any order.
    void begin_load(Workspace& workspace) const;
    void load_row(std::size_t y, const double* g, Workspace& workspace) const;
    void end_load(std::span<double> b, Workspace& workspace) const;
    /// What the border adds to the right-hand side.
    std::span<const double> border_load() const { return border_load_; }
    double border_flux() const { return border_flux_; }

    /// The mean of a function of phi's space, and the L2 norm without it.
    double mean(std::span<const double> phi) const;
    double norm_without_mean(std::span<const double> phi) const;

    /// The potential with Psi = identity.
    virtual std::vector<double> identity() const = 0;
    /// Which space phi is in.
    virtual const KnotVector& space() const = 0;
    virtual const LineTable& tests() const = 0;

  protected:
    /// Which sum along x a field is made of, and how it is summed along y.
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
    std::vector<double> integrals_; ///< of the functions of phi's space along a line
};

/// p >= 2, and splines with a continuous derivative.
std::unique_ptr<SplineForm> make_standard_form(const SplineLine& line, const NormalTrace& trace);
/// p >= 2.
std::unique_ptr<SplineForm> make_mixed_form(const SplineLine& line, const NormalTrace& trace);

} // namespace gaspard
