// The monitor m(x) > 0: where it is large, the mesh is to be dense. Cells get the area theta / m; only ratios
// of m count, not its unit.
//
// A simulation brings its own: as a function (monitor/function.hpp), or as a class derived from Monitor,
// which looks up many points at once. On the periodic square points may lie outside of [0, 1]^2, and m has to
// be periodic. What m does within less than a few cells, the mesh cannot follow.
#pragma once

#include "core/base/parameter.hpp"
#include "core/base/points.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/mesh/space.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

/// Immutable once a run has it. Calls may come from several threads at once when a run has more than one.
/// What it throws comes through (see Run::step).
class Monitor {
  public:
    virtual ~Monitor() = default;
    /// m at every point (physical coordinates), positive and finite. `values` has x.size() entries.
    virtual void values(const Points& x, std::span<double> values) const = 0;
    /// grad m at every point, in the coordinates of space, on a sphere tangent to it; resizes `gradients` to
    /// x.size().
    virtual void gradients(const Points& x, Points& gradients) const = 0;
    /// Throws InputError where m <= 0 or not finite for some point of space, naming the parameter to change.
    virtual void check() const = 0;
    /// The only kind of space whose points the monitor can be asked for, where it is so bound.
    virtual std::optional<SpaceKind> made_for() const { return std::nullopt; }
    /// On a sphere: a direction around which m does not change when it turns, where there is one.
    virtual std::optional<Vec3> symmetry_axis() const { return std::nullopt; }
};

class TensorMonitor; // core/monitor/tensor.hpp

/// What a monitor may use while it is made, after the domain's operators are there. Monitors that read files
/// or compute on the mesh report progress, and throw Interrupted when asked to stop.
struct MonitorContext {
    Space space{};                                 ///< of the domain
    const Discretisation* discretisation = nullptr; ///< null: the monitor is made without a run
    std::filesystem::path folder{};                ///< relative paths start here; empty: the working directory
    Progress progress{};
    std::stop_token stop{};
};

/// A kind of monitor as the user sees it. Adding one is a file with its rows and `make`, and a line in
/// monitors.cpp.
struct MonitorType {
    std::string name;
    std::string label;
    std::string help;
    std::string equation;                                        ///< as in the source, with the rows' symbols
    std::function<std::vector<ParameterRow>(const Space&)> rows; ///< a point has other keys on a sphere
    /// Exactly one of these two, for a scalar or a tensor monitor. Throw InputError.
    std::function<std::shared_ptr<const Monitor>(const Values&, const MonitorContext&)> make{};
    std::function<std::shared_ptr<const TensorMonitor>(const Values&, const MonitorContext&)> make_tensor{};
    /// Further rows that follow from the values of `rows`, such as the constants of a formula; a row that
    /// they depend on has the role defines_rows. Throws InputError if the values have no meaning.
    std::function<std::vector<ParameterRow>(const Values&, const Space&)> further_rows{};
};

/// All built-in monitors, in the order in which `list` shows them.
std::vector<MonitorType> monitor_types();

} // namespace gaspard
