// The table of mesh formats and their writers. Existing files are replaced only when the new file is
// complete. All writers throw MachineError if the file cannot be written.
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"
#include "core/mesh/space.hpp"
#include "core/scenario/output_rows.hpp"
#include "core/scenario/scenario.hpp"
#include "core/session/snapshot.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

struct Catalogue;

struct SplinePatch;
struct Tessellation;

/// Wavefront OBJ: corner vertices and straight-edged cells at the given positions, in the order of cells.
/// Numbers read back to the same doubles. Surfaces are written as "f" records, lines as "l", solids as all
/// faces of every cell.
void write_obj(const std::filesystem::path& file, const Mesh& mesh, const Points& positions);

/// The triangles of a tessellation as "f" records and the edges of cells as "l" records, for nodes at the
/// given positions; numbers read back to the same doubles.
void write_obj(const std::filesystem::path& file, const Tessellation& shape, const Points& positions);

/// Binary glTF 2.0, single precision: triangles coloured by the monitor and edges as lines. POSITION is x;
/// the morph target is xi - x with default weight 0, and an animation moves from xi to x. Far from the
/// origin, positions are relative to the middle of the mesh, which is the translation of the node.
void write_glb(const std::filesystem::path& file, const Snapshot& snapshot);
/// The same with another tessellation.
void write_glb(const std::filesystem::path& file, const Snapshot& snapshot, const Tessellation& shape);

/// The frames of a film of one mesh as binary glTF 2.0: POSITION is the last one, each of the others is a
/// morph target, and the animation shows `rate` of them per second. Colours are those of the last one.
void write_animated_glb(const std::filesystem::path& file,
                        const std::vector<std::shared_ptr<const Snapshot>>& frames, double rate);

/// VTK XML unstructured grid at x, exact doubles, with cells of their own kind and order. Point data: nodal
/// fields, displacement (x - xi) and xi. Cell data: cell fields. Field data: the numbers of the report.
void write_vtu(const std::filesystem::path& file, const Snapshot& snapshot);

/// Gmsh 2.2 text file at x, exact doubles. Physical groups: "domain" and those of border_groups(); a periodic
/// square pairs its sides. Node data: nodal fields, displacement and xi.
void write_msh(const std::filesystem::path& file, const Snapshot& snapshot, const Space& space);

/// Binary PLY: corners in double precision with the monitor and its colour, and straight-edged faces; edges
/// for lines, the boundary for solids.
void write_ply(const std::filesystem::path& file, const Snapshot& snapshot);
/// The same with the triangles of a tessellation.
void write_ply(const std::filesystem::path& file, const Snapshot& snapshot, const Tessellation& shape);

/// CSV with a header, one line per node: node (from 0), xi_1, xi_2, xi_3 and x, y, z (as many as the space
/// has dimensions), and the nodal fields; decimals read back to the same doubles.
void write_csv(const std::filesystem::path& file, const Snapshot& snapshot);

/// UGRID 1.0 in NetCDF: corners and straight edges at the given positions (xi or x), exact doubles, with the
/// nodal fields at corners, the cell fields and the measure of each cell. If all nodes xi have the same
/// distance from the origin, also longitude and latitude.
void write_ugrid(const std::filesystem::path& file, const Snapshot& snapshot, const Points& positions,
                 const std::string& title);

/// The results of a run that writers use. If `view` looks into a solid, its files of surfaces (obj, glb, ply,
/// curved or not) have what is seen of the adapted mesh, caps included.
struct RunResult {
    const Snapshot& snapshot;
    const std::vector<StepReport>& history;
    Space space;        ///< of the domain; tells whether opposite sides are identified
    const Values& view; ///< of view_rows()
    double curve_tolerance = default_curve_tolerance; ///< relative to the size of the mesh
    std::shared_ptr<const SplinePatch> patch{}; ///< the mesh as splines; null if it is not a spline mesh
    std::string subject{};                      ///< names the problem in captions; may be empty
    std::optional<double> tolerance{}; ///< of the series by which the run is judged; plots of it show it
};

struct Format {
    std::string name;               ///< as in --formats: "obj"
    std::string help;               ///< one line
    std::vector<std::string> files; ///< names of its files in the output folder
    void (*write)(const std::filesystem::path& folder, const RunResult& result);
    bool splines_only = false; ///< requires a spline domain
};

const std::vector<Format>& formats();
/// Whether the output section of a scenario lists the format.
bool exports(const Scenario& scenario, std::string_view format);
/// Parses a list such as "obj,glb". Throws InputError for an unknown name; the message names the nearest.
std::vector<const Format*> parse_formats(std::string_view list);
/// The formats of a scenario. Throws InputError also if a format does not support the domain.
std::vector<const Format*> formats_of(const Catalogue& catalogue, const Scenario& scenario);

} // namespace GASPARD_API
