// A method computes the next state from the current one. It is independent of output, windows and files.
#pragma once

#include "core/base/export.hpp"
#include "core/base/field.hpp"
#include "core/base/parameter.hpp"
#include "core/base/series.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/monitor/problem_data.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

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

/// Whether an iterate may be the last one.
enum class Ending {
    by_criterion, ///< if MethodType::criterion is below method.tolerance
    not_yet,      ///< no: the method is on a coarser mesh
    complete,     ///< yes, whatever the criterion: all steps that were asked for are made
};

/// Results of evaluating one iterate.
struct Evaluation {
    double residual = 0;      ///< as MethodType::residual describes it; of the mesh where the iteration ends
    SeriesValues series{};    ///< of Method::series(), those that every iterate has, in their order
    double step_size = 0;     ///< of the update that led here; 0 at the start
    int inner_iterations = 0; ///< of the linear solver, for that update
    std::string note{};       ///< a sentence for people, where something is to be said of it
    bool anew = false;        ///< the method returned to an earlier iterate: progress is judged from here
    Ending ending = Ending::by_criterion;
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
    /// What the method reports of an iterate besides the residual.
    virtual std::vector<SeriesInfo> series() const { return {}; }
    /// The values, of the state last evaluated, of those series() that are `measured`, in their order.
    virtual std::vector<double> measures(const ProblemData&) { return {}; }
    /// Whether the method knows its map everywhere, not only at nodes. The mesh is then tangled where the map
    /// folds, whatever its cells, which only approximate the map.
    virtual bool knows_map() const { return false; }
    /// Requires knows_map(): the cells in which the map of the state last evaluated folds, ascending.
    virtual std::vector<std::uint32_t> folded_cells() { return {}; }
    /// Where the nodes stand in the exact solution; null where it is not known.
    virtual std::shared_ptr<const Points> exact(const ProblemData&) { return nullptr; }
    /// The values, of the state last evaluated, of MethodType::fields, in their order; those are empty that
    /// the problem does not have, such as a second component of the solution.
    virtual std::vector<std::vector<double>> fields(const ProblemData&) { return {}; }
    /// New values of the method's own parameters; the state stays.
    virtual void configure(const Values& values) = 0;
    /// Maximum number of threads, including that of the caller; results do not depend on it.
    virtual void use_threads(int) {}
    /// Total CPU time of this method's threads other than the caller's.
    virtual double other_cpu_seconds() const { return 0; }
};

/// McRae et al. (5.1) divided by the norm of <v, theta>, and what corresponds to it elsewhere.
SeriesInfo normalised_residual();
/// A series of methods that start on coarser meshes: the mesh of the update that led to the iterate, 0 for
/// the mesh of the run, 1 for the next coarser one, and so on; 0 where no update was made.
SeriesInfo level_series();

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

/// Makes a method. May take as long as a factorisation, and be stopped on the way (Interrupted).
using MethodMaker = std::function<std::unique_ptr<Method>(const MethodContext&, const Values&)>;

/// A type of method as the user sees it.
struct MethodType {
    std::string name;
    std::string label;
    std::string help;
    std::vector<ParameterRow> rows; ///< beyond those that every method has (tolerance, max_iterations, ...)
    SeriesInfo residual = normalised_residual(); ///< its name is "residual"
    /// The run converges when this series is below method.tolerance: the residual, or one of Method::series()
    /// that every iterate has.
    std::string criterion = "residual";
    std::vector<FieldInfo> fields{}; ///< of nodes and cells: colours and files offer them
    std::string colour = "monitor";  ///< what its meshes are coloured by, unless the view says otherwise
    MethodMaker make;                ///< on the domains whose Capability has none of its own
};
/// Default values of the rows of the method, those that it has on a domain, and common_method_rows().
Values default_values(const MethodType& type, const std::vector<ParameterRow>& on_domain = {});

/// Rows of every method (tolerance, max_iterations, diagnostics, ...); Run reads them.
std::vector<ParameterRow> common_method_rows();

MethodType relaxation_method();
MethodType accelerated_method();
MethodType quasi_newton_method();
MethodType newton_method();
MethodType automatic_method();
MethodType picard_method();
MethodType picard_mixed_method();
/// These two on solids: for Capability::makers.
MethodMaker picard_in_solids(bool mixed);
MethodType mesh_pde_method();
MethodType bakhvalov_method();
MethodType shishkin_method();
MethodType equidistribute_method();
MethodType nvfem_method();

} // namespace GASPARD_API
