// A Monge-Ampere equation on some domain, seen from its methods: what they need of it, whatever the cells.
//
//   phi -> x, sigma, theta, r    and    u with <grad v, grad u> = r_v
//
// A State of every one of them is one array, "phi", the potential; its layout says domain and resolution
// ("plane periodic Q2 n=60").
#pragma once

#include "core/fem/ellipticity.hpp"
#include "core/method/method.hpp"

namespace gaspard {

/// The constant that m det(dx/dxi) is to equal: the integral of m over the physical domain / measure of the
/// computational one, which a map of the domain to itself keeps.
SeriesInfo theta_series();

class Equation {
  public:
    virtual ~Equation() = default;
    Equation(const Equation&) = delete;
    Equation& operator=(const Equation&) = delete;

    const std::string& layout() const { return layout_; }
    std::size_t unknowns() const { return unknowns_; }
    /// phi = 0: every node stands at xi.
    State initial_state() const { return state_of(std::vector<double>(unknowns_, 0.0)); }
    State state_of(std::vector<double> phi) const;
    /// The state's array; the state must be of this layout.
    std::vector<double>& potential(State& state) const;
    const std::vector<double>& potential(const State& state) const;

    /// At most so many, the caller's own included; results do not depend on it.
    virtual void use_threads(int threads) = 0;
    virtual double other_cpu_seconds() const = 0;

    /// The same map on this mesh, from a state of any mesh of the same domain; nothing for others. `of`: as
    /// for Method::adopt.
    virtual std::optional<State> adopt(const State& other, const Discretisation* of) = 0;
    /// The same from a map of an equation on another mesh of the same domain, which is left as it is.
    virtual State adopt(Equation& other, std::span<const double> phi) = 0;
    /// The same equation on the next coarser mesh; null where that would be of no use. Throws Interrupted
    /// when asked to stop.
    virtual std::unique_ptr<Equation> coarser(const Progress& progress, std::stop_token stop) const = 0;

    /// Everything below is of the potential last evaluated, and, but for patches, allocates nothing with one
    /// thread.
    virtual Evaluation evaluate(const Monitor& monitor, std::span<const double> phi) = 0;
    /// Where the mesh's nodes stand, in physical coordinates.
    virtual const Points& positions() const = 0;
    /// What is reported of a potential, and the values of the `measured` ones; as for Method.
    virtual std::vector<SeriesInfo> series() const { return {theta_series()}; }
    virtual std::vector<double> measures(const Monitor&) { return {}; }
    /// Positions alone, of another potential.
    virtual void move(std::span<const double> phi) = 0;
    /// r, not normalised.
    virtual std::span<const double> residual() const = 0;
    virtual Ellipticity ellipticity() const = 0;
    /// Fills u, the direction of the relaxation: r . w is its H1 product with w.
    virtual void direction(std::span<double> u) = 0;

    /// How much of the linearisation one wants: all of it, or without the part from m(x), as (3.10) has it.
    enum class Linearised { fully, frozen_monitor };
    /// The equation linearised at the potential last evaluated, for what follows; theta is one of its
    /// unknowns. Positive definite, but for the constant, where the map is convex.
    virtual void linearise(const Monitor& monitor, Linearised how) = 0;
    /// out = -(dr/dphi) w, exact for the discrete equation.
    virtual void derivative(std::span<const double> w, std::span<double> out) = 0;
    /// Fills u, roughly the w whose derivative is r: linear in r, the same until linearise() is called again.
    virtual void precondition(std::span<const double> r, std::span<double> u) = 0;

  protected:
    Equation(std::string layout, std::size_t unknowns) : layout_(std::move(layout)), unknowns_(unknowns) {}

  private:
    std::string layout_;
    std::size_t unknowns_;
};

/// The equation that a discretisation is of.
std::unique_ptr<Equation> make_equation(std::shared_ptr<const Discretisation> discretisation);

/// The step of the relaxation that damps the fastest and the slowest of the linearised equation alike, a
/// little shortened: beyond 2 / fastest it is unstable.
/// Positive and at most longest_step, also for what is no map any more.
double stable_step(const Ellipticity& ellipticity);
inline constexpr double longest_step = 1e3;

/// What preconditions -div( m cof(I + sigma) grad ), whose eigenvalues lie between theta and m theta where
/// the map is close to a solution: P = S K S, K the Laplacian's matrix, S = diag(m^(1/5)) (in the manner of
/// Concus and Golub, 1973, who have the square root of a scalar coefficient). This is 1 / S from m.
double preconditioner_scale(double monitor);

} // namespace gaspard
