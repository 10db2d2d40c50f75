// The fixed-point iteration of Benamou, Froese and Oberman with splines; Bahari, Habbal, Ratnani,
// Sonnendruecker (2024), sections 4 and 6:
//
//   div Psi^{k+1} = s G(Psi^k),   G = sqrt( (div Psi)^2 + 2 (f(Psi) - det grad Psi) )         (4.2), (6.2)
//
//   s = (flux of Psi through the boundary) / (integral of G)
//
// s makes the Neumann problem solvable; the paper does not state it, but its numbers agree with it. The
// standard and the mixed form are in spline/spline_forms.hpp. T denotes the map phi^k -> phi^{k+1}.
#pragma once

#include "core/base/points.hpp"
#include "core/spline/spline_forms.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// f(xi, Psi), the prescribed Jacobian determinant of the map.
class JacobianSource {
  public:
    virtual ~JacobianSource() = default;
    /// f at the quadrature points of rows y, y + 1, ...; psi holds Psi at these points (x and y).
    virtual void values(std::size_t y, const Points& psi, std::span<double> f) const = 0;
    /// f and its derivatives df/dPsi, in x and y of `gradient`.
    virtual void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const = 0;
};

class Bfo {
  public:
    /// `shift`: epsilon of the paper (standard form). 0 eliminates the constant exactly instead.
    explicit Bfo(std::shared_ptr<const SplineForm> form, double shift = 0);

    const SplineForm& form() const { return *form_; }
    double shift() const { return shift_; }

    /// Properties of a map, evaluated at the quadrature points.
    struct Shape {
        double convexity = 0; ///< smallest eigenvalue of grad Psi
        /// lambda_min and lambda_max of phi - T(phi), linearised with f fixed:
        ///
        ///   lambda = 1 - s (eigenvalue of grad Psi) / G
        double slowest = 0, fastest = 0;
    };
    /// next = T(phi). An empty phi stands for Psi = 0 everywhere, also at the boundary: the start of the
    /// paper. Fills `shape` if it is not null.
    void iterate(const JacobianSource& source, std::span<const double> phi, std::span<double> next,
                 Shape* shape = nullptr);
    /// b, the right-hand side of the Poisson problem A next = b of the last iterate(); valid until the next
    /// call of anything here.
    std::span<const double> load() const { return load_; }
    /// r = A (next - phi) with next = T(phi) and A the matrix of the Poisson problem. It equals load() minus
    /// the load of the iteration that led to phi.
    void residual(std::span<const double> phi, std::span<const double> next, std::span<double> r);
    /// Solves A u = r.
    void poisson(std::span<const double> r, std::span<double> u);

    /// Linearises at phi. If `moving` is false, the derivative of f with respect to Psi is neglected.
    void linearise(const JacobianSource& source, std::span<const double> phi, bool moving);
    /// out = -dr/dphi w, exact for the discrete problem.
    void derivative(std::span<const double> w, std::span<double> out);

  private:
    /// Number of rows of quadrature points per band; bands are processed one at a time.
    std::size_t band() const { return form_->line().upper.degree + std::size_t{1}; }
    /// Computes G at the `count` points of a band.
    void fill_g(std::size_t count);
    void clear_rows(std::size_t count);
    void read_rows(std::size_t y, std::size_t rows, const SplineForm::Workspace& workspace);

    std::shared_ptr<const SplineForm> form_;
    double shift_;
    SplineForm::Workspace workspace_;
    Points psi_, slope_;                       ///< for one band: Psi, df/dPsi
    std::vector<double> xx_, xy_, yy_, f_, g_; ///< for one band: grad Psi, f, G
    std::vector<double> load_;
    /// Coefficients of the linearisation at all quadrature points:
    ///
    ///   dG = parts[0] dpsi1 + parts[1] dpsi2 + parts[2] dpsi1,x + parts[3] dpsi1,y + parts[4] dpsi2,y
    std::array<std::vector<double>, map_fields> parts_;
    std::vector<double> g_load_; ///< <G, v>
    double g_integral_ = 0;
};

/// |<v, 2>|, the l2 norm over all basis functions v, by which |r| is normalised: 2 is the divergence of the
/// identity map.
double norm_of_divergence(const SplineForm& form);

} // namespace gaspard
