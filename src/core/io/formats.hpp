// The table of mesh formats, and each format's writer.
#pragma once

#include "core/session/snapshot.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// Corner vertices and straight-edged faces in the cells' order, at the given positions. Coordinates read
/// back to the same doubles. Surfaces: "f" records. Lines: "l". Solids: every face of every cell, as "f" in
/// the cells' order.
void write_obj(const std::filesystem::path& file, const Mesh& mesh, const Points& positions);

/// Binary glTF 2.0: triangles coloured by the monitor and the cells' edges as lines; POSITION is x, the morph
/// target is xi - x with default weight 0, and an animation plays from xi to x. Single precision.
void write_glb(const std::filesystem::path& file, const Snapshot& snapshot);

struct Format {
    std::string name;               ///< as in --formats: "obj"
    std::string help;               ///< one line
    std::vector<std::string> files; ///< the names it writes into the output folder
    void (*write)(const std::filesystem::path& folder, const Snapshot& snapshot);
};

const std::vector<Format>& formats();
/// Parses "obj,glb". Throws InputError for an unknown name, with the nearest.
std::vector<const Format*> parse_formats(std::string_view list);

} // namespace gaspard
