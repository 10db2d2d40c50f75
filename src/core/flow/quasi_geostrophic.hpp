// Quasi-geostrophic flow on the doubly periodic unit square, after Bernsen, Bokhove, van der Vegt (2006) and
// section 5.1.3 of McRae, Cotter, Budd (2018):
//
//   u = U + grad^perp psi = U + (-psi_y, psi_x),    lap psi - Fr psi = q,    q_t + div(q u) = 0
//
// n x n squares, each cut into two triangles from its lower left to its upper right corner. q is linear on
// each triangle and discontinuous between them, psi continuous and linear on each triangle:
//
//   (grad v, grad psi) + Fr (v, psi) = -(v, q)                                  for all continuous v
//   (v, q_t) = (q, u . grad v) - sum over edges of < [v], q_upwind u . n >       for all discontinuous v
//
// u . n is continuous and div u = 0 on each triangle, both exactly: the flux through an edge is the
// difference of psi at its ends. Therefore the integral of q is conserved, a constant q stays, the upwind
// flux dissipates enstrophy, and, with U = 0, discretisation in space conserves energy. Steps are those of
// the third-order SSP Runge-Kutta method of Shu and Osher (1988); psi is solved for in each stage. The
// systems of psi and of the projection are circulant; FFT solves them to rounding.
//
// One thread; the same bits for the same input. Steps do not allocate.
#pragma once

#include "core/flow/flow_options.hpp"
#include "core/linear/circulant.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

class QuasiGeostrophicFlow {
  public:
    /// Corners of the two triangles of a square. q has 6 n^2 values, a plane of n^2 squares (x fastest) for
    /// each of: lower left, lower right and upper right corner of the lower triangle; lower left, upper right
    /// and upper left corner of the upper triangle.
    static constexpr std::size_t corners = 6;

    /// At rest (q = 0), at time 0. Throws InputError if an option is out of its range.
    explicit QuasiGeostrophicFlow(const FlowOptions& options);

    const FlowOptions& options() const { return options_; }
    std::size_t cells() const { return n_; } ///< n
    double time() const { return time_; }
    const std::vector<double>& q() const { return q_; }
    /// Throws InputError if the size is not 6 n^2, if a value is not finite, or if Fr = 0 but not the mean.
    void set_state(std::span<const double> q, double time = 0);

    /// The largest step with the Courant number of the options at the present velocity; infinite at rest.
    double stable_step();
    /// One step of this length, which should not exceed stable_step().
    void step(double dt);
    /// Advances by `duration` >= 0. Before each step the rest is divided into equal steps, as few as the
    /// Courant number allows. Returns the number of steps. Throws InputError if the flow is so fast that more
    /// than FlowOptions::most_steps would be needed, and Interrupted if asked to stop.
    std::size_t advance(double duration, const std::stop_token& stop = {});

    /// psi at the n x n nodes (i / n, j / n), x fastest, without the part of U.
    std::span<const double> psi();
    FlowDiagnostics diagnostics();
    /// The L2 projection of q to continuous functions, linear on each triangle (with the consistent mass
    /// matrix): n^2 values at the nodes.
    void project(std::span<double> nodal);

  private:
    /// Edges of one row of squares: the flux through each, and its product with the upwind q and the shape
    /// functions of both ends, integrated along it.
    struct EdgeRow {
        std::vector<double> flux, first, second;
    };
    void solve_psi(const std::vector<double>& q);
    void load(const std::vector<double>& q);
    void find_edges_across(const double* q, std::size_t j, EdgeRow& row) const;
    void find_edges_up(const double* q, std::size_t j);
    void find_edges_within(const double* q, std::size_t j);
    void stage(const std::vector<double>& now, double dt, double share_of_start, std::vector<double>& next);
    void update_row(const double* now, std::size_t j, double dt, double share_of_start, double* next) const;
    double largest_rate() const;

    FlowOptions options_;
    std::size_t n_;
    double time_ = 0;
    bool psi_is_current_ = false;
    std::vector<double> q_, stage_, other_;
    CirculantTransform transform_;
    std::vector<double> inverse_, inverse_mass_; ///< factors of the two systems
    std::vector<double> load_, psi_;
    std::vector<double> corners_before_,
        corners_now_;                     ///< parts of the load: right and upper corners of a row
    std::vector<double> whole_psi_;       ///< psi with U, (n + 1)^2 nodes
    EdgeRow below_, above_, up_, within_; ///< horizontal, vertical and diagonal edges
};

} // namespace gaspard
