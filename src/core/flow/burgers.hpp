// Burgers' equation on its own adapted mesh x_0 = 0 < ... < x_N = 1:
//
//   u_t + u u_x = nu u_xx  on (0, 1),      u(0, t) and u(1, t) given
//
// Space: u is continuous and linear on each cell. For the basis functions phi_i, which move with the mesh,
//
//   d/dt (u, phi_i) = (u^2/2 - x' u - nu u_x, d/dx phi_i),      x' the velocity of the mesh, linear on cells
//
// with all integrals exact: conservative, and a constant u stays on every moving mesh. Time: over a step the
// nodes move along straight lines; the two-stage SDIRK method of order 2 (L-stable, gamma = 1 - 1/sqrt 2),
// each stage by Newton's method with tridiagonal matrices.
//
// Mesh: the nodes at the end of a step equidistribute the arc length m = sqrt(1 + (alpha u_x)^2) of u at its
// beginning. m is constant on cells and smoothed, (I - lambda delta^2) ms = m with lambda = (N / 25)^2: over
// a part of the nodes that does not depend on N, so that meshes of different N are samples of one map, and
// errors are of order 2 in 1/N. The nodes follow from the inverse of the integral of ms (de Boor).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

struct BurgersOptions {
    std::size_t cells = 100; ///< N, 4 to 4096
    double nu = 0.005;       ///< > 0
    double alpha = 1;        ///< > 0
    bool adapted = true;     ///< false: the uniform mesh
    double courant = 1;      ///< step times the largest |u|, over the width of the smallest cell
};

/// Start and boundary values: u(x, t) for t = 0, and for x = 0 and 1.
using BurgersData = std::function<double(double x, double t)>;
/// The travelling front, an exact solution: u = (1 - tanh((x - x0 - t/2) / (4 nu))) / 2.
BurgersData burgers_front(double nu, double x0);
/// sin(2 pi x) + sin(pi x) / 2, 0 at both ends: steepens into a front that moves to the right.
BurgersData burgers_sine();

class Burgers {
  public:
    /// At time 0, on the mesh of the start. Throws InputError if an option is out of its range.
    Burgers(const BurgersOptions& options, BurgersData data);

    double time() const { return time_; }
    const std::vector<double>& x() const { return x_; }
    const std::vector<double>& u() const { return u_; }
    void set_state(std::span<const double> x, std::span<const double> u, double time);

    double stable_step() const; ///< by the Courant number
    /// Newton's method must converge; throws InputError otherwise.
    void step(double dt);
    /// Advances by `duration` >= 0 in steps that the Courant number allows. Throws Interrupted if asked to
    /// stop.
    void advance(double duration, const std::stop_token& stop = {});

  private:
    std::vector<double> equidistributed() const;
    void solve_stage(const std::vector<double>& right, const std::vector<double>& mesh, double weight,
                     double time, std::vector<double>& u) const;
    std::vector<double> fluxes(const std::vector<double>& mesh, const std::vector<double>& u) const;

    BurgersOptions options_;
    BurgersData data_;
    double time_ = 0;
    std::vector<double> x_, u_, velocity_;
};

/// The L2 norm of the error of u at the present time, by Gauss rules with three points on the cells.
double l2_error(const Burgers& equation, const BurgersData& exact);

} // namespace gaspard
