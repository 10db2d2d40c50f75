// The monitor m(x) > 0: the mesh is dense where m is large. Cells get an area proportional to 1 / m; only
// ratios of m matter, not its unit.
//
// A simulation supplies its own monitor as a function (monitor/function.hpp) or as a class derived from
// Monitor, which evaluates many points per call and need only define values(). A run asks it for points of
// its domain:
//
//   periodic square   0 <= x, y < 1, z = 0; m is periodic
//   walls             0 <= x, y <= 1, z = 0
//   sphere            |x| = R
//   patch             x = F(Psi), z = 0 in the plane; Psi may leave the parameter square slightly.
//                     Differences (Monitor::gradients) also take points beside the patch: across its edges,
//                     and off a surface in space
//   convex            the inside of the target, of the source for its density, z = 0
//
// and checks the values after every call: they must be positive and finite. The built-in monitors are also
// asked for other images of points of the periodic square, and for points near a sphere. The mesh cannot
// resolve features of m that are smaller than a few cells.
#pragma once

#include "core/base/export.hpp"
#include "core/base/field.hpp"
#include "core/base/parameter.hpp"
#include "core/base/points.hpp"
#include "core/function/scalar_function.hpp"
#include "core/mesh/data_context.hpp"
#include "core/mesh/space.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

/// What a monitor says about itself once it is made.
struct MonitorReport {
    std::vector<std::string> notes{}; ///< sentences for people: "12 of 3600 values are missing"
    /// By keys of text rows, the values that they may take: the variables of a file.
    std::map<std::string, std::vector<std::string>> choices{};
    std::string advice{}; ///< what to do if no mesh can follow it: "set ... = ..."; may be empty
};

/// Immutable once a run has it. May be called from several threads at once if a run uses more than one.
/// Exceptions propagate to the caller of the run (see Run::step).
class Monitor {
  public:
    virtual ~Monitor() = default;
    /// m at every point (physical coordinates), positive and finite. `values`: x.size() entries. Any unit:
    /// the iterations for c m are those for m, for all c > 0 with which m is a normal double.
    virtual void values(const Points& x, std::span<double> values) const = 0;
    /// grad m at every point, in Cartesian coordinates; on a sphere the tangential gradient. Resizes
    /// `gradients` to x.size(). The default leaves none: a run then takes differences of the values with a
    /// step of 1e-5 times the size of its domain (longest side, radius), between points of the domain; on a
    /// patch between x +- the step along each coordinate axis, wherever these points are.
    virtual void gradients(const Points&, Points& gradients) const { gradients.resize(0); }
    /// Throws InputError if m <= 0 or not finite at some point; the message names the parameter to change.
    /// The default does nothing: a run checks the values themselves.
    virtual void check() const {}
    /// The kind of space to which the monitor is restricted; nullopt if it has no restriction.
    virtual std::optional<SpaceKind> made_for() const { return std::nullopt; }
    /// What the monitor was made of, as values at points of the domain (such as u and the indicator of a
    /// derived monitor): the fields of MonitorType::fields or some of them, in their order.
    virtual std::vector<Field> fields(const Points&) const { return {}; }
    /// For the user, beside the results.
    virtual MonitorReport report() const { return {}; }
    /// On a sphere: the axis of rotational symmetry of m; nullopt if there is none.
    virtual std::optional<Vec3> symmetry_axis() const { return std::nullopt; }
    /// The function u from which m was made, whose interpolation error the mesh is to reduce
    /// (diagnostics/interpolation_error.hpp); null: m itself.
    virtual std::shared_ptr<const ScalarFunction> solution() const { return nullptr; }
};

class TensorMonitor; // core/monitor/tensor.hpp

/// What a monitor may use while it is made.
using MonitorContext = DataContext;

/// Where rows and formula of a monitor are written. On a domain with a box (Space::box), the figure is scaled
/// and moved to it; see monitor/placement.hpp.
enum class MonitorFigure {
    none,        ///< in the coordinates of the domain, wherever it lies
    unit_square, ///< for [0, 1]^2
    unit_disk,   ///< for the unit disk
};

/// A stage in the making of a monitor, or a part of it, as the window groups its rows.
struct MonitorStage {
    std::string label; ///< "Average"
    std::string field; ///< that shows its result: one of MonitorType::fields, or "monitor"
    /// Of its rows, in any order; "u." stands for all that begin with it. If the first one is of kind
    /// boolean, it switches the stage.
    std::vector<std::string> keys;
};

/// A type of monitor as the user sees it. To add one, write a file with its rows and `make`, and add a line
/// to monitors.cpp.
struct MonitorType {
    std::string name;
    std::string label;
    std::string help;
    std::string equation; ///< as in the source, with the rows' symbols
    MonitorFigure figure = MonitorFigure::none;
    std::vector<SpaceKind>
        spaces{};       ///< offered as a part of others on these alone (combine_type.cpp); empty: all
    bool solids = true; ///< likewise: on solids
    std::function<std::vector<ParameterRow>(const Space&)> rows; ///< points have different keys on a sphere
    /// Exactly one of these two is set, for a scalar or a tensor monitor. They throw InputError.
    std::function<std::shared_ptr<const Monitor>(const Values&, const MonitorContext&)> make{};
    std::function<std::shared_ptr<const TensorMonitor>(const Values&, const MonitorContext&)> make_tensor{};
    /// Further rows that depend on the values of `rows`, such as the constants of a formula, and on those of
    /// further ones, as far as the values have these already (base/growing_values.hpp); a row on which others
    /// depend has the role defines_rows. Throws InputError if the values are invalid.
    std::function<std::vector<ParameterRow>(const Values&, const Space&)> further_rows{};
    /// The same monitor as a formula to change (function/formula.hpp), with the rows' keys as parameters; in
    /// the coordinates of the space, also where the figure is placed. Not set if it has none.
    std::function<std::string(const Space&)> formula{};
    /// Fields of nodes that its monitors may have besides m (Monitor::fields): colours and files offer them.
    std::vector<FieldInfo> fields{};
    std::vector<MonitorStage> stages{}; ///< rows of none of them come first
};

/// All built-in monitors, in the order of `gaspard list`.
std::vector<MonitorType> monitor_types();

} // namespace GASPARD_API
