// Which cells of a solid are shown at all, before some of them are cut.
#pragma once

#include "core/tessellate/colouring.hpp"
#include "core/tessellate/inside_choice.hpp"
#include "core/tessellate/solid_faces.hpp"

#include <span>
#include <vector>

namespace gaspard {

/// Per cell 1 or 0. `values`: of the cells, in the order of choice.only; empty where they are not known, and
/// the condition does not count. `x`: the nodes, where planes hide whole cells.
std::vector<char> visible_cells(const Mesh& mesh, const SolidFaces& faces, const InsideChoice& choice,
                                std::span<const std::vector<double>> values, const Points& x);

/// Per condition of choice.only the values of all cells; empty where the snapshot has none. `colour`: what
/// the colours show, for conditions on "value".
std::vector<std::vector<double>> condition_values(ColouringMaker& maker, const Snapshot& snapshot,
                                                  const InsideChoice& choice, const std::string& colour);
/// Of values at nodes, the mean over the corners of every cell.
std::vector<double> corner_means(const Mesh& mesh, std::span<const double> nodes);

} // namespace gaspard
