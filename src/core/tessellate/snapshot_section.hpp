// What is seen of the solid of a snapshot when one looks into it (core/tessellate/inside_choice.hpp).
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/inside_choice.hpp"
#include "core/tessellate/tessellation.hpp"

#include <optional>
#include <string>

namespace gaspard {

/// The section of a mesh of hexahedra with its nodes at `x`. The values by which cells are hidden are those
/// of the snapshot; `colour`: what the colours show, for conditions on "value".
Tessellation snapshot_section(const Snapshot& snapshot, const Points& x, const InsideChoice& inside,
                              ColouringMaker& maker, const std::string& colour);

/// The surface of the adapted solid that `view`, values of view_rows(), lets one see, without points of
/// hidden parts and segment_sides; nullopt if that is the whole boundary, if the mesh is no solid, or if
/// nothing is left. Throws InputError as inside_choice().
std::optional<Tessellation> surface_of_cut(const Snapshot& snapshot, const Values& view);

/// "view.cut and view.only leave nothing to see of the solid": names what `view` has set.
std::string nothing_left(const Values& view);
/// That sentence if it is so; else empty.
std::string note_on_hidden(const Snapshot& snapshot, const Values& view);

} // namespace gaspard
