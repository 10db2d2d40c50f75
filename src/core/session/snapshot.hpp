// The results of a run as immutable values, for the window, the output files and the tests.
//
//   residual          of the equation, normalised (MethodType::residual), the same measure for all methods
//   equidistribution  standard deviation / mean over the cells of M_i, McRae et al. (5.2):
//                     integral of m over physical cell i / measure of computational cell i
//   Jacobian          det dx/dxi of a physical cell; a cell is tangled where it is <= 0 anywhere, or, if the
//                     method knows its map everywhere, where the map folds
#pragma once

#include "core/base/export.hpp"
#include "core/base/field.hpp"
#include "core/base/points.hpp"
#include "core/diagnostics/interpolation_error.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/patch_list.hpp"
#include "core/monitor/monitor.hpp"
#include "core/session/series_table.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

enum class RunStatus {
    preparing,       ///< operators are being prepared
    running,         ///< further steps are possible
    converged,       ///< the residual (MethodType::criterion) is below the tolerance, or all steps are made
    iteration_limit, ///< method.max_iterations was reached
    stalled,         ///< the criterion has not decreased for many iterations
    diverged,        ///< residual or theta became too large, or not finite; the mesh may be tangled as well
    tangled,         ///< the final mesh has tangled cells, although the iteration did not diverge
    invalid_input,   ///< the monitor of the next time cannot be made; the mesh is that of the time before
    interrupted,     ///< stopped on request
    failed,          ///< an internal error or a system error
};

std::string_view status_name(RunStatus status); ///< "iteration-limit"
bool is_final(RunStatus status);

/// What is measured of an iterate (method.diagnostics), each with what precedes it.
enum class Diagnostics {
    none,     ///< tangled cells alone, of the last iterate
    geometry, ///< Jacobians; nothing that evaluates the monitor
    full,     ///< the monitor's mass of the cells, equidistribution, exact maps, the method's measures
};

/// The report of one iterate. Iteration 0 is the start; iteration k is the result of k updates.
struct StepReport {
    int iteration = 0;
    double residual = 0;
    double step_size = 0;                       ///< of the update that led here; 0 at the start
    std::optional<std::size_t> tangled_cells{}; ///< empty where the mesh was not measured
    /// Of the linear solver, for this update, and for those of the time steps after it that the history
    /// leaves out.
    int inner_iterations = 0;
    int all_iterations = 0; ///< cumulative, with those that time steps are made of
    double seconds = 0;     ///< cumulative wall time of solving
    double cpu_seconds = 0; ///< cumulative CPU time of all threads that solve
    RunStatus status = RunStatus::running;
    std::string note{}; ///< a sentence for people, where something is to be said
    /// The names of the series, and the values of those after the residual and without the step size; what
    /// was not measured (method.diagnostics_every) is not a number. value() reads them.
    std::shared_ptr<const SeriesTable> series = common_series();
    std::vector<double> values{};

    /// Whether the mesh was measured.
    bool measured() const { return tangled_cells.has_value(); }
    /// Of one of series->all(), by its name or its place there. Empty where there is none of that name, and
    /// where it has no value: it was not measured, or no step was made yet.
    std::optional<double> value(std::string_view name) const;
    std::optional<double> value(std::size_t place) const;
    /// The series must be there, and be neither residual nor step size, which are members.
    void set(std::string_view name, double value);
};

/// An iterate as an immutable value, which may be shared between threads.
struct Snapshot {
    std::shared_ptr<const Mesh> mesh; ///< cells and xi; shared by all snapshots of a run
    Points x;                         ///< where the nodes stand, in the mesh's numbering
    std::shared_ptr<const Points>
        exact{}; ///< where they would stand in the exact solution; null where unknown
    /// Cells in which the map folds, ascending; null if only the cells are known.
    std::shared_ptr<const std::vector<std::uint32_t>> tangled{};
    std::shared_ptr<const Points> control{}; ///< control points that may be moved; null where there are none
    std::size_t control_columns = 0;         ///< Discretisation::control_columns()
    std::shared_ptr<const Points> target{};  ///< Discretisation::target_outline()
    std::shared_ptr<const PatchList> patches{};            ///< of a file with several; otherwise null
    std::shared_ptr<const MonitorReport> monitor_report{}; ///< null: the monitor says nothing
    /// The interpolation errors on the uniform and on an adapted mesh, as last measured (Run::interpolation):
    /// of this mesh if its version is that of the snapshot, else of one before it. Null where they were not
    /// measured.
    std::shared_ptr<const InterpolationComparison> interpolation{};
    /// monitor (of nodes), jacobian and, with full diagnostics, mass (M_i) of cells; those of the method
    /// and of the monitor; with interpolation errors, those of mesh_colours() with these names
    std::vector<Field> fields;
    StepReport report;
    std::uint64_t version = 0; ///< increases with every iterate

    /// The field with this name; null if there is none.
    const Field* field(std::string_view name) const {
        for (const auto& f : fields)
            if (f.name == name) return &f;
        return nullptr;
    }
};

} // namespace GASPARD_API
