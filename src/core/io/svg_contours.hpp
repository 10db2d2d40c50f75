// Contour lines of a drawing: segments between numbered points, so that they can be joined to long lines.
#pragma once

#include "core/io/mesh_outline.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/colouring.hpp"

#include <cstdint>
#include <vector>

namespace gaspard {

struct SvgContours {
    Points x;                         ///< ends of segments; those of neighbours are one
    std::vector<Side> segments;       ///< between these points, in the order of cells
    std::vector<std::uint32_t> cells; ///< the cell that each segment lies in
    std::vector<double> levels;       ///< what the field is there
};

/// At the levels of the colouring, for nodes at `x`. Empty without levels and for cells that are no surface.
SvgContours svg_contours(const Snapshot& snapshot, const Colouring& colouring, const Points& x);

} // namespace gaspard
