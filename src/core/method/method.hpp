// A method turns a state into the next one; it prints nothing and knows no thread, window or file.
#pragma once

#include "core/base/field.hpp"
#include "core/base/parameter.hpp"
#include "core/base/series.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/monitor/problem_data.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

/// What an iteration changes, as named arrays. `layout` says what they mean ("plane periodic Q2 n=60"): a
/// state fits a method exactly when the layouts are equal.
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

/// The numbers of one iterate, as the method knows them.
struct Evaluation {
    double residual = 0;      ///< as MethodType::residual describes it
    SeriesValues series{};    ///< of Method::series(), those that every iterate has, in their order
    double step_size = 0;     ///< of the update that led here; 0 at the start
    int inner_iterations = 0; ///< of the linear solver, for that update
    std::string note{};       ///< a sentence for people, where something is to be said of it
};

class Method {
  public:
    virtual ~Method() = default;
    /// The state in which every node stands at xi.
    virtual State initial_state() const = 0;
    /// The same map for this method's own layout, made from a state of another resolution or method; nothing
    /// where there is no way. `of` is the discretisation on which the state was made, where the caller has
    /// it: it saves making those operators again.
    virtual std::optional<State> adopt(const State& other, const Discretisation* of) = 0;
    /// Evaluates the equation at `state` and leaves it as it is.
    virtual Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) = 0;
    /// One update of the unknowns, then the evaluation of what came out. The last evaluate() or step() must
    /// have been of this very state and data. A result that is not finite is a value (the run ends as
    /// diverged).
    virtual Evaluation step(const ProblemData& data, State& state, std::stop_token stop) = 0;
    /// Where the mesh's nodes stand for the state last evaluated, in physical coordinates.
    virtual const Points& positions() = 0;
    /// What the method reports of an iterate besides the residual.
    virtual std::vector<SeriesInfo> series() const { return {}; }
    /// The values, of the state last evaluated, of those series() that are `measured`, in their order.
    virtual std::vector<double> measures(const ProblemData&) { return {}; }
    /// The values, of the state last evaluated, of MethodType::fields, in their order.
    virtual std::vector<std::vector<double>> fields(const ProblemData&) { return {}; }
    /// New values of the method's own parameters; the state stays.
    virtual void configure(const Values& values) = 0;
    /// At most so many, the caller's own included; results do not depend on it.
    virtual void use_threads(int) {}
    /// CPU time that threads other than the caller's have spent for this method so far.
    virtual double other_cpu_seconds() const { return 0; }
};

/// McRae et al. (5.1) divided by the norm of <v, theta>, and what corresponds to it elsewhere.
SeriesInfo normalised_residual();

class NonlinearProblem; // core/method/nonlinear_problem.hpp

/// What a method is made of.
struct MethodContext {
    std::shared_ptr<const Discretisation> discretisation;
    /// The nonlinear problem on this discretisation, from the row of the capability table; empty if the row has
    /// none. May be called more than once.
    std::function<std::unique_ptr<NonlinearProblem>()> problem{};
    Progress progress{};
    std::stop_token stop{};
};

/// A kind of method as the user sees it.
struct MethodType {
    std::string name;
    std::string label;
    std::string help;
    std::vector<ParameterRow> rows; ///< beyond those that every method has (tolerance, max_iterations, ...)
    SeriesInfo residual = normalised_residual(); ///< its name is "residual"
    std::vector<FieldInfo> fields{};             ///< of nodes and cells: colours and files offer them
    /// May take as long as a factorisation, and be stopped on the way (Interrupted).
    std::function<std::unique_ptr<Method>(const MethodContext&, const Values&)> make;
};
/// The defaults of the method's rows and of those that every method has.
Values default_values(const MethodType& type);

/// Rows that every method has; the run reads them.
std::vector<ParameterRow> common_method_rows();

MethodType relaxation_method();
MethodType accelerated_method();
MethodType quasi_newton_method();
MethodType newton_method();
MethodType automatic_method();
MethodType picard_method();
MethodType picard_mixed_method();

} // namespace gaspard
