// A discrete nonlinear problem R(u) = 0 for a mesh, as the methods see it: relaxation, Anderson's and Newton's
// method and nested iteration are written against this interface, whatever the unknowns and the cells.
//
//   u -> positions x, residual r = R(u)
//   direction   d = P^-1 r            with which u + s d is an explicit step
//   linearise   A = -dR/du            Newton's update is A w = r
//
// A State of such a problem is one array of unknowns; its layout names the domain, the discretisation and the
// resolution ("plane periodic Q2 n=60").
#pragma once

#include "core/method/method.hpp"

namespace gaspard {

/// What an iterate is judged by, beside its residual.
struct IterateShape {
    /// Positive while the iterate is admissible: the smallest eigenvalue of a convex map's Jacobian, or the
    /// smallest Jacobian determinant; 1 if every iterate is admissible. Methods do not accept steps that lose
    /// most of it.
    double admissibility = 1;
    /// The longest stable step along direction(), roughly.
    double stable_step = 1;
    /// Condition number of the linearisation, preconditioned as in direction(); an estimate.
    double condition = 1;
};

class NonlinearProblem {
  public:
    virtual ~NonlinearProblem() = default;
    NonlinearProblem(const NonlinearProblem&) = delete;
    NonlinearProblem& operator=(const NonlinearProblem&) = delete;

    const std::string& layout() const { return layout_; }
    std::size_t size() const { return size_; } ///< number of unknowns
    /// The unknowns for which every node stands at xi; zeros unless the problem says otherwise.
    virtual std::vector<double> start() const { return std::vector<double>(size_, 0.0); }
    State state_of(std::vector<double> unknowns) const;
    /// The state's array. The state must have this layout (GASPARD_CHECK).
    std::vector<double>& unknowns(State& state) const;
    const std::vector<double>& unknowns(const State& state) const;

    /// At most this many threads, including the caller's; results do not depend on the number.
    virtual void use_threads(int) {}
    virtual double other_cpu_seconds() const { return 0; }

    /// The same map on this mesh, from a state of any mesh of the same domain; nothing for others. `of`: as
    /// for Method::adopt.
    virtual std::optional<State> adopt(const State& other, const Discretisation* of) = 0;
    /// The same from the unknowns of the same problem on another mesh (made by coarser()), which is unchanged.
    virtual State adopt(NonlinearProblem& other, std::span<const double> unknowns) = 0;
    /// The same problem on the next coarser mesh; null if there is no useful one. Throws Interrupted.
    virtual std::unique_ptr<NonlinearProblem> coarser(const Progress& progress,
                                                      std::stop_token stop) const = 0;

    // Everything below refers to the unknowns last evaluated and, except on spline patches, allocates nothing
    // with one thread.

    virtual Evaluation evaluate(const ProblemData& data, std::span<const double> unknowns) = 0;
    /// Of the mesh's nodes, in physical coordinates.
    virtual const Points& positions() const = 0;
    /// Positions alone, of other unknowns.
    virtual void move(std::span<const double> unknowns) = 0;
    /// What is reported of an iterate, and the values of the `measured` series; as for Method.
    virtual std::vector<SeriesInfo> series() const { return {}; }
    virtual std::vector<double> measures(const ProblemData&) { return {}; }
    /// r, not normalised.
    virtual std::span<const double> residual() const = 0;
    virtual IterateShape shape() const = 0;
    /// Fills d.
    virtual void direction(std::span<double> d) = 0;

    /// The full linearisation, or the one without the derivative of the monitor, as in McRae et al. (3.10).
    enum class Linearised { fully, frozen_monitor };
    virtual void linearise(const ProblemData& data, Linearised how) = 0;
    /// out = A w, exact for the discrete problem.
    virtual void derivative(std::span<const double> w, std::span<double> out) = 0;
    /// Fills w, approximately A^-1 r: linear in r, and constant until linearise() is called again.
    virtual void precondition(std::span<const double> r, std::span<double> w) = 0;

    /// The data for a fraction t of the way from a problem whose solution is start() (t = 0) to `data` itself
    /// (t = 1). The result may refer to `data`.
    virtual ProblemData continued(const ProblemData& data, double t) const = 0;
    /// "m^0.5": how a message names that data.
    virtual std::string name_of_continued(double t) const = 0;

  protected:
    /// `array`: the name of the unknowns in a State.
    NonlinearProblem(std::string layout, std::size_t size, std::string array)
        : layout_(std::move(layout)), size_(size), array_(std::move(array)) {}

  private:
    std::string layout_;
    std::size_t size_;
    std::string array_;
};

} // namespace gaspard
