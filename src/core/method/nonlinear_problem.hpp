// A discrete nonlinear problem R(u) = 0 for a mesh. Relaxation, Anderson's method, Newton's method and nested
// iteration use only this interface, independently of unknowns and cells.
//
//   evaluate    u -> positions x, residual r = R(u)
//   direction   d = P^-1 r                             u + s d is an explicit step
//   linearise   A = -dR/du                             the Newton update w solves A w = r
//
// A State of such a problem is one array of unknowns; its layout names the domain, the discretisation and the
// resolution ("plane periodic Q2 n=60").
#pragma once

#include "core/method/method.hpp"

#include <cstdint>

namespace gaspard {

/// Properties of an iterate, in addition to its residual, by which methods accept steps.
struct IterateShape {
    /// Positive while the iterate is admissible: the smallest eigenvalue of a convex map's Jacobian, or the
    /// smallest Jacobian determinant; 1 if every iterate is admissible. Methods do not accept steps that lose
    /// most of it.
    double admissibility = 1;
    /// Estimate of the longest stable step along direction().
    double stable_step = 1;
    /// Estimated condition number of the linearisation, preconditioned as in direction().
    double condition = 1;
};

class NonlinearProblem {
  public:
    virtual ~NonlinearProblem() = default;
    NonlinearProblem(const NonlinearProblem&) = delete;
    NonlinearProblem& operator=(const NonlinearProblem&) = delete;

    const std::string& layout() const { return layout_; }
    std::size_t size() const { return size_; } ///< number of unknowns
    /// The unknowns of the identity map x = xi; zero by default.
    virtual std::vector<double> start() const { return std::vector<double>(size_, 0.0); }
    State state_of(std::vector<double> unknowns) const;
    /// The state's array. The state must have this layout (GASPARD_CHECK).
    std::vector<double>& unknowns(State& state) const;
    const std::vector<double>& unknowns(const State& state) const;

    /// New values of the method's rows; those of Capability::method_rows are for the problem.
    virtual void configure(const Values&) {}
    /// Maximum number of threads, including that of the caller; results do not depend on it.
    virtual void use_threads(int) {}
    virtual double other_cpu_seconds() const { return 0; }

    /// The same map on this mesh, from a state on any mesh of the same domain; nullopt for other domains.
    /// `of`: see Method::adopt.
    virtual std::optional<State> adopt(const State& other, const Discretisation* of) = 0;
    /// Prolongation or restriction: the same map from the unknowns of the same problem on another mesh, made
    /// by coarser(). `other` is not changed.
    virtual State adopt(NonlinearProblem& other, std::span<const double> unknowns) = 0;
    /// The same problem on the next coarser mesh; null if no coarser mesh is useful. Throws Interrupted if
    /// asked to stop.
    virtual std::unique_ptr<NonlinearProblem> coarser(const Progress& progress,
                                                      std::stop_token stop) const = 0;

    // Everything below refers to the unknowns last evaluated and, except on spline patches, allocates nothing
    // with one thread.

    virtual Evaluation evaluate(const ProblemData& data, std::span<const double> unknowns) = 0;
    /// Positions x of the mesh nodes, in physical coordinates.
    virtual const Points& positions() const = 0;
    /// Updates only positions(), for other unknowns.
    virtual void move(std::span<const double> unknowns) = 0;
    /// What is reported of an iterate, and the values of the `measured` series; as for Method.
    virtual std::vector<SeriesInfo> series() const { return {}; }
    virtual std::vector<double> measures(const ProblemData&) { return {}; }
    /// As for Method.
    virtual bool knows_map() const { return false; }
    virtual std::vector<std::uint32_t> folded_cells() { return {}; }
    /// The residual vector r, not normalised.
    virtual std::span<const double> residual() const = 0;
    virtual IterateShape shape() const = 0;
    /// d = P^-1 r.
    virtual void direction(std::span<double> d) = 0;
    /// Whether steps along direction() may diverge however short. Where no Newton step is accepted, methods
    /// then take only those that do not increase the residual, and begin anew from start() if they came from
    /// elsewhere.
    virtual bool begins_anew() const { return false; }
    /// A step u + s d is reported as s / step_unit(data): where r has the unit of m, s has that of 1/m.
    virtual double step_unit(const ProblemData& data) const { return data.unit; }

    /// The full linearisation, or the one without the derivative of the monitor, as in McRae et al. (3.10).
    enum class Linearised { fully, frozen_monitor };
    virtual void linearise(const ProblemData& data, Linearised how) = 0;
    /// out = A w, exact for the discrete problem.
    virtual void derivative(std::span<const double> w, std::span<double> out) = 0;
    /// Fills w with an approximation of A^-1 r. The operator is linear and does not change until the next
    /// linearise().
    virtual void precondition(std::span<const double> r, std::span<double> w) = 0;

    /// Data of the continuation at t in [0, 1]: for t = 0 the solution is start(), for t = 1 the result is
    /// `data`. The result may share objects with `data`.
    virtual ProblemData continued(const ProblemData& data, double t) const = 0;
    /// Name of that data in messages: "m^0.5".
    virtual std::string name_of_continued(double t) const = 0;

  protected:
    /// `array`: name of the array of unknowns in a State.
    NonlinearProblem(std::string layout, std::size_t size, std::string array)
        : layout_(std::move(layout)), size_(size), array_(std::move(array)) {}

  private:
    std::string layout_;
    std::size_t size_;
    std::string array_;
};

} // namespace gaspard
