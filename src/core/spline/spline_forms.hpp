// The two discretisations of Bahari et al. on the parameter square [0, 1]^2 or cube [0, 1]^3: a potential
// phi, its map Psi, and the Poisson problem of each iteration with source g.
//
// Standard form (4.5): phi in S^p (x) S^p (x S^p),  Psi = grad phi,
//
//   <grad phi, grad v> + shift <phi, v> = <Psi . n, v>_boundary - <g, v>      for all v
//
// Mixed form (6.4): phi in S^p-1 (x) S^p-1 (x S^p-1),  Psi_d in S^p along d and S^p-1 along the others, see
// (2.13),
//
//   <Psi, v> + <phi, div v> = 0       for all v with v . n = 0,
//   <div Psi, w> = <g, w>             for all w,           Psi . n prescribed on the boundary
//
// In the mixed form Psi follows from phi, so that phi is the only unknown of either form. Sums are factorised
// by direction. In arrays over tensor products x runs fastest. A slab is what belongs to one point of the
// last direction: a row of the square, a plane of the cube.
#pragma once

#include "core/base/team.hpp"
#include "core/linear/fast_diagonalisation.hpp"
#include "core/spline/line_table.hpp"
#include "core/spline/tensor_space.hpp"

#include <array>
#include <memory>

namespace gaspard {

/// The same line in all directions: S^p on [0, 1] with p + 1 Gauss points per cell.
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

/// Psi . n at the quadrature points of the faces, up to sign: psi_d where coordinate d is 0 (low) and 1
/// (high).
template <std::size_t D>
struct FaceTrace {
    std::array<std::vector<double>, D> low, high;
};
using NormalTrace = FaceTrace<2>;

/// points^D, also of other numbers per direction.
template <std::size_t D>
constexpr std::size_t tensor_size(std::size_t per_direction) {
    std::size_t all = 1;
    for (std::size_t d = 0; d < D; ++d) all *= per_direction;
    return all;
}

/// The trace of the identity, (3.14): 0 and 1.
template <std::size_t D = 2>
FaceTrace<D> identity_trace(const SplineLine& line);
/// The integral of Psi . n over the boundary.
template <std::size_t D>
double flux(const SplineLine& line, const FaceTrace<D>& trace);

/// The fields psi_1 to psi_D and the upper triangle of grad Psi by rows: psi1, psi2, psi1,x, psi1,y, psi2,y.
/// The lower triangle is equal by symmetry; in the mixed form it is replaced by the upper one, which
/// reproduces the paper's numbers.
template <std::size_t D>
inline constexpr std::size_t map_fields_of = D + D*(D + 1) / 2;
inline constexpr std::size_t map_fields = map_fields_of<2>;

template <std::size_t D>
class TensorForm {
  public:
    virtual ~TensorForm() = default;

    const SplineLine& line() const { return line_; }
    const SplineGrid& quadrature() const { return quadrature_; }
    /// Number of unknowns per direction, and in total.
    std::size_t size() const { return poisson_.size(); }
    std::size_t unknowns() const { return tensor_size<D>(size()); }
    /// Number of quadrature points of a slab.
    std::size_t slab() const { return tensor_size<D - 1>(line_.points.size()); }
    const FastDiagonalisation& poisson() const { return poisson_; }

    static constexpr std::size_t fields = map_fields_of<D>, halves = D * (D + 1) / 2;
    using Fields = std::array<double*, fields>;

    struct Workspace {
        std::unique_ptr<Team> team; ///< whose workers share the sums, in three dimensions
        FastDiagonalisation::Workspace poisson;
        std::array<std::vector<double>, D> map; ///< coefficients of psi_1 to psi_D; of phi: the first
        /// After the sums along all directions but the last: one slab per function along that.
        std::array<std::vector<double>, halves> half;
        std::vector<std::array<std::vector<double>, 3>> turned; ///< of each worker
        std::vector<double> load; ///< one slab per function along the last direction
    };
    Workspace make_workspace(std::size_t workers = 1) const;

    /// Prepares row() for the map of phi; with `border` zero, for its derivative.
    enum class Border { given, zero };
    void expand(std::span<const double> phi, Border border, const SplineGrid& grid, std::size_t fields,
                Workspace& workspace) const;
    /// Evaluates the first `fields` fields on a slab of the grid given to expand. May be called by several
    /// threads.
    void row(const SplineGrid& grid, std::size_t slab, std::size_t fields, const Fields& out,
             const Workspace& workspace) const;

    /// b = <g, v> for every v of phi's space; load_row takes the slabs of g at the quadrature points in any
    /// order.
    void begin_load(Workspace& workspace) const;
    void load_row(std::size_t slab, const double* g, Workspace& workspace) const;
    void end_load(std::span<double> b, Workspace& workspace) const;
    /// The contribution of the boundary to the right-hand side.
    std::span<const double> border_load() const { return border_load_; }
    double border_flux() const { return border_flux_; }

    /// The mean of a function of phi's space, and its L2 norm after subtraction of the mean.
    double mean(std::span<const double> phi) const;
    double norm_without_mean(std::span<const double> phi) const;

    /// Psi of phi as splines.
    virtual std::array<SplineFunction, D> map(std::span<const double> phi) const = 0;
    /// The potential whose map is the identity.
    virtual std::vector<double> identity() const = 0;
    /// The univariate space of phi.
    virtual const KnotVector& space() const = 0;
    virtual const LineTable& tests() const = 0;

  protected:
    /// The sum along one direction with the functions of S^p or S^p-1 or a derivative of them.
    struct LineSum {
        bool upper = true;
        int derivative = 0;
        friend bool operator==(const LineSum&, const LineSum&) = default;
    };
    /// Of a component of Workspace::map, the sums along all directions but the last.
    struct Half {
        std::size_t component = 0;
        std::array<LineSum, D - 1> sums{};
    };
    /// A field: a half and the sum along the last direction to apply to it.
    struct FieldTerm {
        std::size_t half = 0;
        LineSum sum{};
    };
    TensorForm(SplineLine line, FastDiagonalisation poisson, const std::array<Half, halves>& all,
               const std::array<FieldTerm, fields>& terms)
        : line_(std::move(line)), quadrature_(line_, line_.points), poisson_(std::move(poisson)),
          halves_(all), terms_(terms) {}
    /// The coefficients from which halves are summed.
    virtual std::array<std::span<const double>, D> components(std::span<const double> phi, Border border,
                                                              Workspace& workspace) const = 0;

    SplineLine line_;
    SplineGrid quadrature_;
    FastDiagonalisation poisson_;
    std::array<Half, halves> halves_;
    std::array<FieldTerm, fields> terms_;
    std::vector<double> border_load_;
    double border_flux_ = 0;
    std::vector<double> integrals_; ///< integrals of the functions of phi's univariate space

  private:
    void sum_halves(const std::array<bool, halves>& wanted,
                    const std::array<std::span<const double>, D>& from, const SplineGrid& grid,
                    Workspace& workspace) const;
};
using SplineForm = TensorForm<2>;
using SolidForm = TensorForm<3>;

/// Requires p >= 2 and splines with a continuous derivative.
template <std::size_t D>
std::unique_ptr<TensorForm<D>> make_standard_form(const SplineLine& line, const FaceTrace<D>& trace);
/// Requires p >= 2.
template <std::size_t D>
std::unique_ptr<TensorForm<D>> make_mixed_form(const SplineLine& line, const FaceTrace<D>& trace);

} // namespace gaspard
