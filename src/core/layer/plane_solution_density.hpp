// Densities of a mesh of a quadrilateral from a computed solution of order 1, in place of ones that know eps:
// along each line of the grid those of an interval (solution_density.hpp), M_11 along lines of constant xi2,
// M_22 along those of constant xi1. Scales are means over each line, so that about half of its cells are
// where u changes fast along it, whatever the size of u there. A quadrilateral has the mean of its two lines.
//
// Curvature is taken with k = 4: the integral of |u''|^(1/2) over a layer does not depend on its width. With
// k = 3 it is eps^(-1/3), and of two layers the one that is resolved first takes all cells.
#pragma once

#include "core/layer/solution_density.hpp"
#include "core/layer/square_mesh_pde.hpp"
#include "core/layer/triangle_problem.hpp"

namespace gaspard {

/// `parameters`: (s, t) of the (cells + 1)^2 nodes, by rows; of `options` the density, not "estimate", and
/// the smoothing, along the lines and across them. Lines on which u does not change take the densities of the
/// nearest that have some; 1 if there are none. Throws InputError if cells < 2 or the sizes do not agree.
TriangleDensities plane_solution_densities(const SolutionMeshOptions& options, const Points& parameters,
                                           int cells, const TriangleSolution& solution);

} // namespace gaspard
