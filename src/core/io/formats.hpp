// The table of mesh formats, and each format's writer. Existing files are replaced when the new one is whole;
// what cannot be written is a MachineError.
#pragma once

#include "core/mesh/space.hpp"
#include "core/scenario/output_rows.hpp"
#include "core/scenario/scenario.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/colour_choice.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct Catalogue;

struct SplinePatch;
struct Tessellation;

/// Corner vertices and straight-edged faces in the cells' order, at the given positions. Coordinates read
/// back to the same doubles. Surfaces: "f" records. Lines: "l". Solids: every face of every cell, as "f" in
/// the cells' order.
void write_obj(const std::filesystem::path& file, const Mesh& mesh, const Points& positions);

/// The triangles of a tessellation as "f" records and the cells' edges as "l" records, for nodes at the given
/// positions; exact.
void write_obj(const std::filesystem::path& file, const Tessellation& shape, const Points& positions);

/// Binary glTF 2.0: triangles coloured by the monitor and the cells' edges as lines; POSITION is x, the morph
/// target is xi - x with default weight 0, and an animation plays from xi to x. Single precision.
void write_glb(const std::filesystem::path& file, const Snapshot& snapshot);
/// The same with cells cut in another way.
void write_glb(const std::filesystem::path& file, const Snapshot& snapshot, const Tessellation& shape);

/// VTK's XML file of an unstructured grid at x, exact doubles, cells of every kind and order as they are.
/// Point data: the fields of nodes, displacement (x - xi) and xi; cell data: the fields of cells; field data:
/// the numbers of the report.
void write_vtu(const std::filesystem::path& file, const Snapshot& snapshot);

/// Gmsh's file, version 2.2 as text, at x, exact doubles. Physical groups: "domain" and those of
/// border_groups(); for a periodic square the sides are paired. Node data: the fields of nodes, displacement
/// and xi.
void write_msh(const std::filesystem::path& file, const Snapshot& snapshot, const Space& space);

/// Binary PLY: corners in double precision with the monitor and its colour, straight-edged faces. Lines:
/// edges. Solids: the border.
void write_ply(const std::filesystem::path& file, const Snapshot& snapshot);

/// UGRID 1.0 in NetCDF: corners and straight edges at the given positions (xi or x), exact doubles; longitude
/// and latitude beside x, y, z where all nodes xi are as far from the origin. With the fields of nodes (at
/// corners) and of cells, and each cell's measure.
void write_ugrid(const std::filesystem::path& file, const Snapshot& snapshot, const Points& positions,
                 const std::string& title);

/// What there is to write of a run.
struct RunResult {
    const Snapshot& snapshot;
    const std::vector<StepReport>& history;
    Space space;                                      ///< of the domain: whether its sides are the same
    ColourChoice colours{};                           ///< of the view
    double curve_tolerance = default_curve_tolerance; ///< of tessellated files, relative to the mesh's size
    std::shared_ptr<const SplinePatch> patch{}; ///< the mesh as splines; null where it is not made of any
};

struct Format {
    std::string name;               ///< as in --formats: "obj"
    std::string help;               ///< one line
    std::vector<std::string> files; ///< the names it writes into the output folder
    void (*write)(const std::filesystem::path& folder, const RunResult& result);
    bool splines_only = false; ///< for domains of splines
};

const std::vector<Format>& formats();
/// Whether a scenario's output section names a format.
bool exports(const Scenario& scenario, std::string_view format);
/// Parses "obj,glb". Throws InputError for an unknown name, with the nearest.
std::vector<const Format*> parse_formats(std::string_view list);
/// Those of a scenario. Throws InputError too where one has nothing to write of its domain.
std::vector<const Format*> formats_of(const Catalogue& catalogue, const Scenario& scenario);

} // namespace gaspard
