// A solid that is looked into (core/tessellate/inside_choice.hpp) as what a drawing shows of it: the
// triangles of its section, of whose sides only some are edges of cells or of cut faces.
#pragma once

#include "core/io/svg_scene.hpp"
#include "core/tessellate/inside_choice.hpp"

namespace gaspard {

/// Of the nodes at xi + blend (x - xi). The values by which cells are hidden, and tangled cells, are those of
/// the snapshot, as in the window. The faces of the scene are triangles between shown points, those of caps
/// the last.
SvgScene svg_section(const Snapshot& snapshot, double blend, const std::optional<Colouring>& colouring,
                     const InsideChoice& inside);

/// Which of the drawn sides lies between these points; null for a side within a face.
const SectionSide* find_section_side(const SvgScene& scene, std::int32_t a, std::int32_t b);

} // namespace gaspard
