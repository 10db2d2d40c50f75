// The equation of the plane, seen from its relaxation: what the methods there share.
//
//   phi -> x, sigma, theta, r    and    u with <grad v, grad u> = r_v        (fem/plane_q2.hpp)
//
// A State of the plane is one array, "phi"; its layout says boundary and cells ("plane periodic Q2 n=60").
#pragma once

#include "core/fem/ellipticity.hpp"
#include "core/fem/plane_q2.hpp"
#include "core/method/method.hpp"

namespace gaspard {

class PlaneEquation {
  public:
    explicit PlaneEquation(std::shared_ptr<const PlaneQ2> plane);

    const PlaneQ2& plane() const { return *plane_; }
    void use_threads(int threads) { room_ = plane_->make_room(threads); }
    double other_cpu_seconds() const { return room_.team->other_cpu_seconds(); }

    const std::string& layout() const { return layout_; }
    State initial_state() const;
    /// The same map for this plane, from a state of any plane with the same boundary; nothing for others.
    std::optional<State> adopt(const State& other);
    /// The same from a map of another of these, which is left as it is.
    State adopt(PlaneEquation& other, std::span<const double> phi);
    /// The state's array; the state must be of this layout.
    std::vector<double>& potential(State& state) const;
    const std::vector<double>& potential(const State& state) const;

    /// Everything below is of the potential last evaluated.
    Evaluation evaluate(const Monitor& monitor, std::span<const double> phi);
    const Points& positions() const { return positions_; }
    /// Positions alone, of another potential.
    void move(std::span<const double> phi) { plane_->positions(phi, positions_, room_); }
    std::span<const double> residual() const { return residual_; }
    /// (I + sigma) at the vertices.
    Ellipticity ellipticity() const { return gaspard::ellipticity(plane_->grid(), monitor_, sigma_); }
    /// Fills u, the direction of the relaxation.
    void direction(std::span<double> u) { plane_->poisson(residual_, u, room_); }

  private:
    std::shared_ptr<const PlaneQ2> plane_;
    std::string layout_;
    PlaneQ2::Room room_;
    Points positions_;
    std::vector<double> monitor_; ///< m at the mesh's nodes
    WeakHessian sigma_;
    std::vector<double> residual_;
};

/// The step of the relaxation that damps the fastest and the slowest of the linearised equation alike, a
/// little shortened: beyond 2 / fastest it is unstable.
double stable_step(const Ellipticity& ellipticity);

/// The plane of a method that works on nothing else.
std::shared_ptr<const PlaneQ2> plane_of(std::shared_ptr<const Discretisation> discretisation);

} // namespace gaspard
