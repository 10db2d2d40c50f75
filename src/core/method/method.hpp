// A method computes the next state from the current one. It is independent of output, windows and files.
#pragma once

#include "core/base/parameter.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/monitor/problem_data.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

/// The unknowns of an iteration, as named arrays. `layout` identifies their meaning ("plane periodic Q2
/// n=60"): a state fits a method if and only if the layouts are equal.
struct State {
    struct Array {
        std::string name;
        std::vector<double> values;
        friend bool operator==(const Array&, const Array&) = default;
    };
    std::string layout;
    std::vector<Array> arrays;

    friend bool operator==(const State&, const State&) = default;
};

/// Results of evaluating one iterate.
struct Evaluation {
    double residual = 0;      ///< normalised: McRae et al. (5.1) divided by the norm of <v, theta>
    double theta = 0;         ///< the constant in m det(dx/dxi) = theta
    double step_size = 0;     ///< step size of the last update; 0 at the start
    int inner_iterations = 0; ///< iterations of the linear solver in that update
    std::string note{};       ///< message for the user; may be empty
};

/// A quality measure defined by the paper of the method.
struct Measure {
    std::string name;
    double value = 0;
    friend bool operator==(const Measure&, const Measure&) = default;
};

class Method {
  public:
    virtual ~Method() = default;
    /// The state of the identity map x = xi.
    virtual State initial_state() const = 0;
    /// The same map in the layout of this method, from a state of another resolution or method; nullopt if it
    /// cannot be transferred. `of`: the discretisation of the other state if the caller has it, which saves
    /// making its operators again; may be null.
    virtual std::optional<State> adopt(const State& other, const Discretisation* of) = 0;
    /// Evaluates the equation at `state`.
    virtual Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) = 0;
    /// One update of the unknowns, then the evaluation of the result. The last call of evaluate() or step()
    /// must have been for the same state and data. The residual may be infinite or NaN; the run then ends as
    /// diverged.
    virtual Evaluation step(const ProblemData& data, State& state, std::stop_token stop) = 0;
    /// Positions x of the mesh nodes for the state last evaluated, in physical coordinates.
    virtual const Points& positions() = 0;
    /// Quality measures of the state last evaluated, as defined by the paper of the method.
    virtual std::vector<Measure> measures(const ProblemData&) { return {}; }
    /// Sets the parameters of the method; the state does not change.
    virtual void configure(const Values& values) = 0;
    /// Maximum number of threads, including that of the caller; results do not depend on it.
    virtual void use_threads(int) {}
    /// Total CPU time of this method's threads other than the caller's.
    virtual double other_cpu_seconds() const { return 0; }
};

class NonlinearProblem; // core/method/nonlinear_problem.hpp

/// Arguments of MethodType::make.
struct MethodContext {
    std::shared_ptr<const Discretisation> discretisation;
    /// The nonlinear problem on this discretisation, from the row of the capability table; empty if the row
    /// has none. May be called more than once.
    std::function<std::unique_ptr<NonlinearProblem>()> problem{};
    Progress progress{};
    std::stop_token stop{};
};

/// A type of method as the user sees it.
struct MethodType {
    std::string name;
    std::string label;
    std::string help;
    std::vector<ParameterRow> rows; ///< in addition to common_method_rows()
    /// May include a factorisation; throws Interrupted if asked to stop.
    std::function<std::unique_ptr<Method>(const MethodContext&, const Values&)> make;
};
/// Default values of the rows of the method and of common_method_rows().
Values default_values(const MethodType& type);

/// Rows of every method (tolerance, max_iterations, diagnostics_every); Run reads them.
std::vector<ParameterRow> common_method_rows();

MethodType relaxation_method();
MethodType accelerated_method();
MethodType quasi_newton_method();
MethodType newton_method();
MethodType automatic_method();
MethodType picard_method();
MethodType picard_mixed_method();

} // namespace gaspard
