// What is seen of a solid when some of its cells are hidden and planes cut others: a tessellation of the
// outer faces of what is left, and of the caps that close the cut cells.
//
// Cells are divided into m^3 parts (core/tessellate/cell_lattice.hpp), these into tetrahedra: the corner of
// the lowest rank forms six with the triangles of the three faces that it is not on, and every face is
// divided along the diagonal through its corner of the lowest rank. Neighbours therefore fit, and a plane
// cuts a tetrahedron in a triangle or a quadrilateral. With distances d it cuts the edge from a to b at
//
//   p = (1 - t) p_a + t p_b,   t = d_a / (d_a - d_b).
//
// Points within 1e-9 of the size of the mesh are on the plane, and count as hidden: of cells whose face lies
// on the plane that on the side that stays has the cap.
#pragma once

#include "core/tessellate/cell_lattice.hpp"
#include "core/tessellate/inside_choice.hpp"
#include "core/tessellate/solid_faces.hpp"
#include "core/tessellate/tessellation.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// Makes the sections of one mesh; keeps what does not change between them. Not for several threads at once.
class SectionMaker {
  public:
    SectionMaker(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const SolidFaces> faces);

    /// `visible`: of visible_cells(). `x`: where the nodes are seen. `pieces`: m, for cells of order 2; of
    /// others it is the order, and many cells that stand apart get fewer. The triangles face outward where
    /// cells are not tangled; those of caps are the last (Tessellation::caps).
    Tessellation make(const Points& x, std::span<const char> visible, const InsideChoice& choice, int pieces);

  private:
    std::shared_ptr<const Mesh> mesh_;
    std::shared_ptr<const SolidFaces> faces_;
    LatticeTable table_;
    double tolerance_;
};

} // namespace gaspard
