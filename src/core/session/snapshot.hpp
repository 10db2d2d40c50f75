// The results of a run as immutable values, for the window, the output files and the tests.
//
//   theta             integral of m over the physical domain / measure of the computational domain
//   residual          norm of m det(dx/dxi) - theta, divided by the norm of theta (method.hpp)
//   equidistribution  standard deviation / mean over the cells of M_i, McRae et al. (5.2):
//                     integral of m over physical cell i / measure of computational cell i
//   Jacobian          det dx/dxi of a physical cell; a cell is tangled if det dx/dxi <= 0 at some point
//
// All of them are dimensionless.
#pragma once

#include "core/base/points.hpp"
#include "core/mesh/mesh.hpp"
#include "core/method/method.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

enum class RunStatus {
    preparing,       ///< operators are being prepared
    running,         ///< further steps are possible
    converged,       ///< the residual is below method.tolerance
    iteration_limit, ///< method.max_iterations was reached
    stalled,         ///< the residual has not decreased for many iterations
    diverged,        ///< residual or theta became too large, or not finite
    tangled,         ///< the final mesh has tangled cells, regardless of the residual
    interrupted,     ///< stopped on request
    failed,          ///< an internal error or a system error
};

std::string_view status_name(RunStatus status); ///< "iteration-limit"
bool is_final(RunStatus status);

/// The report of one iterate. Iteration 0 is the start; iteration k is the result of k updates.
struct StepReport {
    int iteration = 0;
    double residual = 0;
    double theta = 0;
    double step_size = 0; ///< step size of the last update; 0 at the start
    // Diagnostics are nullopt if they were skipped (method.diagnostics_every).
    std::optional<double> equidistribution{};
    /// RMS distance of the vertices, and of all nodes, from their exact positions; nullopt if no exact map is
    /// known.
    std::optional<double> exact_rms{}, exact_rms_nodes{};
    std::optional<double> min_jacobian{}, max_jacobian{};
    std::optional<std::size_t> tangled_cells{};
    std::vector<Measure> measures{}; ///< quality measures of the method (Method::measures)
    int inner_iterations = 0;        ///< iterations of the linear solver in this update
    double seconds = 0;              ///< cumulative wall time of solving
    double cpu_seconds = 0;          ///< cumulative CPU time of all solver threads
    RunStatus status = RunStatus::running;
    std::string note{}; ///< message for the user; may be empty
};

enum class FieldPlace { node, cell };

/// One value for every node or cell, in the numbering of the mesh.
struct Field {
    std::string name; ///< "monitor" (nodes); "mass" (M_i) and "jacobian" (minimum over the cell) (cells)
    std::string unit; ///< may be empty
    FieldPlace place = FieldPlace::node;
    std::vector<double> values;
};

/// An iterate as an immutable value, which may be shared between threads.
struct Snapshot {
    std::shared_ptr<const Mesh> mesh; ///< cells and xi; shared by all snapshots of a run
    Points x;                         ///< node positions, in the numbering of the mesh
    std::shared_ptr<const Points> exact{};   ///< node positions of the exact map; null if unknown
    std::shared_ptr<const Points> control{}; ///< movable control points; null if there are none
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

} // namespace gaspard
