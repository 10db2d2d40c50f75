// The mixed finite elements of McRae, Cotter, Budd on the unit square with n x n square cells, doubly
// periodic or with walls:
//
//   V = Q2,   Sigma = (Q2)^{2x2} symmetric,   vertices x and monitor m in Q1
//
//   x = xi + Pi_Q1 grad phi                                                               (3.5)
//   <tau, sigma> = -<div tau, grad phi>              for all tau in Sigma                 (3.8)
//   theta = integral of m det(I + sigma) / area                                           (3.6)
//   r_v = <v, m det(I + sigma) - theta>              for all v in V                       (3.3), (5.1)
//   <grad v, grad u> = r_v                           for all v in V, mean of u = 0        (3.7)
//
// All integrals are exact: with m in Q1, sigma and v in Q2 the integrand has degree 7 in each direction,
// which takes 4 Gauss points. Walls: phi is even about them, so that its normal derivative and sigma_12
// vanish there and nodes slide along the sides.
//
// A Q2 function is an array of size() x size() values, x fastest; along a line, unknown 2 c is vertex c and
// 2 c + 1 the midpoint of cell c. Mesh nodes are those of unit_square_mesh(n), also for periodic domains.
#pragma once

#include "core/base/team.hpp"
#include "core/fem/determinant_load.hpp"
#include "core/fem/line_map.hpp"
#include "core/linear/tensor_poisson.hpp"
#include "core/mesh/discretisation.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

class PlaneQ2 final : public Discretisation {
  public:
    explicit PlaneQ2(LineGrid grid);

    std::shared_ptr<const Mesh> mesh() const override { return mesh_; }
    std::size_t unknowns() const override { return size() * size(); }
    const LineGrid& grid() const { return grid_; }
    std::size_t size() const { return grid_.size(2); } ///< unknowns per direction

    /// Threads and buffers of one caller; with one thread, operators do not allocate.
    struct Workspace {
        struct Worker {
            std::vector<double> in, out; ///< a strip of lines, transposed
        };
        std::shared_ptr<Team> team;
        std::vector<Worker> workers;
        std::vector<DeterminantLoad::Workspace> load;
        TensorPoisson::Workspace poisson;
        std::vector<double> a, b;
        std::vector<double> rows; ///< one number per row of nodes
    };
    /// `threads` is a maximum; small grids use fewer. Results do not depend on it.
    Workspace make_workspace(int threads = 1) const;

    /// (3.5): x at the mesh nodes.
    void positions(std::span<const double> phi, Points& x, Workspace& workspace) const;
    /// x - xi at the mesh nodes; linear in phi.
    void displacement(std::span<const double> phi, Points& d, Workspace& workspace) const;
    /// (3.8) with sigma eliminated exactly.
    void hessian(std::span<const double> phi, WeakHessian& sigma, Workspace& workspace) const;

    struct Residual {
        double theta = 0;
        double normalised = 0; ///< l2 norm of r / l2 norm of <v, theta>, (5.1)
    };
    /// (3.6) and (5.1) for the monitor's values at the mesh nodes; fills r.
    Residual residual(std::span<const double> monitor, const WeakHessian& sigma, std::span<double> r,
                      Workspace& workspace) const;
    /// The derivative of r in the direction (dm, dsigma), dm at the mesh nodes; fills dr.
    void residual_derivative(std::span<const double> monitor, const WeakHessian& sigma,
                             std::span<const double> d_monitor, const WeakHessian& d_sigma,
                             std::span<double> dr, Workspace& workspace) const;
    /// (3.7): u = K^-1 r with mean 0, K the stiffness matrix. u may be r.
    void poisson(std::span<const double> r, std::span<double> u, Workspace& workspace) const;

    /// The potential on this grid whose Laplacian is that of `phi` on another grid with the same boundary;
    /// the initial guess after a change of resolution. (Interpolating phi itself creates kinks in the
    /// Hessian.)
    std::vector<double> transfer(const PlaneQ2& from, std::span<const double> phi, Workspace& from_workspace,
                                 Workspace& workspace) const;
    std::vector<double> transfer(const LineGrid& from, std::span<const double> phi,
                                 Workspace& workspace) const;

  private:
    /// Applies a map along y or along x to `lines` lines.
    void along_y(const LineMap& map, const double* in, double* out, std::size_t lines,
                 Workspace& workspace) const;
    void along_x(const LineMap& map, const double* in, double* out, std::size_t lines,
                 Workspace& workspace) const;
    std::vector<double> line_weights() const;
    Residual take_mean(std::span<double> r, Workspace& workspace) const;
    /// b = <v, f> along the first index.
    void apply_mass(const double* f, double* b) const;

    LineGrid grid_;
    std::shared_ptr<const Mesh> mesh_;
    LineMap second_;   ///< -M^-1 <v', u'>: weak second derivative
    LineMap first_;    ///< M^-1 <v, u'>: first derivative, an odd function
    LineMap slope_q1_; ///< L2 projection of u' to degree 1, odd
    LineMap value_q1_; ///< L2 projection of u to degree 1, even
    DeterminantLoad load_;
    TensorPoisson poisson_;
    std::vector<double> weights_; ///< <v, 1> along a line
};

} // namespace gaspard
