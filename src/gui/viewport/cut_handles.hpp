// Handles of the planes that cut a solid open (core/tessellate/cut_planes.hpp): an arrow from a point of the
// plane along its normal. The mouse moves the plane by the arrow's foot and turns it by the arrow's tip.
#pragma once

#include "core/tessellate/cut_planes.hpp"
#include "gui/viewport/viewport.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace gaspard {

struct CutHandle {
    std::size_t wedge = 0, plane = 0; ///< which plane of the cut
    bool turns = false;               ///< the tip; else the foot
    Vec3 foot, tip;                   ///< of the arrow
    Vec3 place() const { return turns ? tip : foot; }
};

/// Two for each plane. `length`: of the arrows, in pixels. A plane across an axis has its foot beside the
/// middle of the mesh.
std::vector<CutHandle> cut_handles(const std::vector<CutWedge>& cut, const PlannedView& shown, double length);

/// The cut whose handle was dragged from one pixel to another. A foot moves along the normal, in steps that
/// fit the mesh, and not beyond the box around it. A tip moves on a sphere around the foot; near an axis the
/// plane is put across that.
std::vector<CutWedge> with_cut_handle_at(std::vector<CutWedge> cut, const CutHandle& handle,
                                         const PlannedView& shown, Pixel from, Pixel to);

/// The corners, in order, of the part of a plane in a box; less than three if they do not meet.
std::vector<Vec3> plane_in_box(const CutPlane& plane, const Box& box);

/// A plane through the middle of a mesh, across the axis that is nearest to the direction of the viewer,
/// whose side is hidden.
CutPlane usual_cut(const Box& box, Vec3 towards_viewer);

/// The arrows of the planes; that of handle number `lit`, if there is one, stands out with its plane.
void draw_cut_handles(ImDrawList& list, const std::vector<CutWedge>& cut,
                      const std::vector<CutHandle>& handles, std::size_t lit, const PlannedView& shown,
                      const Theme& theme, float scale);
/// "cut.0.foot", "cut.1.tip", by the number of the plane.
std::string item_name(const std::vector<CutWedge>& cut, const CutHandle& handle);

} // namespace gaspard
