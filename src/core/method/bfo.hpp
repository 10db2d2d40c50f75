// The fixed-point iteration of Benamou, Froese and Oberman in splines; Bahari, Habbal, Ratnani,
// Sonnendruecker (2024), sections 4 and 6:
//
//   div Psi^k+1 = s G(Psi^k),   G = sqrt( (div Psi)^2 + 2 (f(Psi) - det grad Psi) )           (4.2), (6.2)
//
// with s = (flux through the border) / (integral of G), so that there is a solution. That is not in the
// paper, but its numbers have it. Two forms, see spline/spline_forms.hpp. T is the map phi^k -> phi^k+1.
#pragma once

#include "core/base/points.hpp"
#include "core/spline/spline_forms.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// f(xi, Psi), the Jacobian that the map is to have.
class JacobianSource {
  public:
    virtual ~JacobianSource() = default;
    /// At the quadrature's points of rows y, y + 1, ..., which stand at psi (x and y).
    virtual void values(std::size_t y, const Points& psi, std::span<double> f) const = 0;
    /// f again, with df/dpsi in x and y of `gradient`.
    virtual void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const = 0;
};

class Bfo {
  public:
    /// `shift` is the paper's epsilon, of the standard form; 0 leaves the constant out instead.
    explicit Bfo(std::shared_ptr<const SplineForm> form, double shift = 0);

    const SplineForm& form() const { return *form_; }
    double shift() const { return shift_; }

    /// What is noticed while a map is looked at, at the quadrature's points.
    struct Shape {
        double convexity = 0; ///< smallest eigenvalue of grad Psi
        /// Extreme eigenvalues of phi - T(phi) linearised with f fixed: 1 - s (eigenvalue of grad Psi) / G.
        double slowest = 0, fastest = 0;
    };
    /// next = T(phi); of an empty phi, where Psi is 0 everywhere, at the border too: the paper's start. Fills
    /// `shape` where somebody wants to know.
    void iterate(const JacobianSource& source, std::span<const double> phi, std::span<double> next,
                 Shape* shape = nullptr);
    /// r = A (T(phi) - phi), A the matrix of the Poisson problem, from both.
    void residual(std::span<const double> phi, std::span<const double> next, std::span<double> r);
    /// u with A u = r.
    void poisson(std::span<const double> r, std::span<double> u);

    /// Linearises at phi; with `moving` false, as if f did not depend on Psi.
    void linearise(const JacobianSource& source, std::span<const double> phi, bool moving);
    /// out = -dr/dphi w, exact.
    void derivative(std::span<const double> w, std::span<double> out);

  private:
    /// So many rows of quadrature points are worked on at once.
    std::size_t band() const { return form_->line().upper.degree + std::size_t{1}; }
    /// G of a band of `count` points.
    void fill_g(std::size_t count);
    void clear_rows(std::size_t count);
    void read_rows(std::size_t y, std::size_t rows, const SplineForm::Workspace& workspace);

    std::shared_ptr<const SplineForm> form_;
    double shift_;
    SplineForm::Workspace workspace_;
    Points psi_, slope_;                       ///< of a band: Psi, df/dPsi
    std::vector<double> xx_, xy_, yy_, f_, g_; ///< of a band: grad Psi, f, G
    std::vector<double> load_;
    // Of the linearisation, at all quadrature points: dG = p1 dpsi1 + p2 dpsi2 + a dpsi1,x + b dpsi1,y + d
    // dpsi2,y
    std::array<std::vector<double>, map_fields> parts_;
    std::vector<double> g_load_; ///< <G, v>
    double g_integral_ = 0;
};

} // namespace gaspard
