// What a run shows of itself: immutable values that the window, the files and the tests read.
#pragma once

#include "core/base/points.hpp"
#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

enum class RunStatus {
    preparing, ///< operators are being made
    running,   ///< may step further
    converged,
    iteration_limit,
    stalled,
    diverged,
    tangled,
    interrupted,
    failed, ///< an internal fault or the machine's
};

std::string_view status_name(RunStatus status); ///< "iteration-limit"
bool is_final(RunStatus status);

/// The report of one iterate. Iteration 0 is the start; iteration k is the result of k updates.
struct StepReport {
    int iteration = 0;
    double residual = 0;
    double theta = 0;
    double step_size = 0;
    // Empty where diagnostics were left out (method.diagnostics_every).
    std::optional<double> equidistribution{};
    /// Of the vertices, and of all nodes, to where the exact map puts them; empty where none is known.
    std::optional<double> exact_rms{}, exact_rms_nodes{};
    std::optional<double> min_jacobian{}, max_jacobian{};
    std::optional<std::size_t> tangled_cells{};
    int inner_iterations = 0; ///< of the linear solver, for this update
    double seconds = 0;       ///< cumulative wall time of solving
    double cpu_seconds = 0;   ///< cumulative CPU time of all threads that solve
    RunStatus status = RunStatus::running;
    std::string note{}; ///< a sentence for people, where something is to be said
};

enum class FieldPlace { node, cell };

struct Field {
    std::string name; ///< "monitor" (of nodes); "mass" (M_i) and "jacobian" (of cells, the smallest)
    std::string unit; ///< may be empty
    FieldPlace place = FieldPlace::node;
    std::vector<double> values;
};

struct Snapshot {
    std::shared_ptr<const Mesh> mesh; ///< cells and xi; shared by all snapshots of a run
    Points x;                         ///< where the nodes stand, in the mesh's numbering
    std::shared_ptr<const Points>
        exact{}; ///< where they would stand in the exact solution; null where unknown
    std::vector<Field> fields;
    StepReport report;
    std::uint64_t version = 0; ///< grows with every iterate

    const Field* field(std::string_view name) const {
        for (const auto& f : fields)
            if (f.name == name) return &f;
        return nullptr;
    }
};

} // namespace gaspard
