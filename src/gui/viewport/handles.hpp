// Places that the mouse can drag: centres and poles of a monitor, as far as its values have any (in the plane
// "..._x" and "..._y", on a sphere "..._latitude" and "..._longitude" in degrees), and the control points of
// a patch in the plane.
#pragma once

#include "core/scenario/scenario.hpp"
#include "gui/viewport/viewport.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

struct Handle {
    std::string first, second; ///< keys: x and y, or latitude and longitude
    bool on_sphere = false;
    Vec3 place;                              ///< in the plane, or of unit length
    std::shared_ptr<const Points> control{}; ///< all of the patch, where this is a control point
    std::size_t number = 0;                  ///< which of them
};

std::vector<Handle> monitor_handles(const Scenario& scenario);
/// Of the patch that a snapshot is of, or as the scenario has moved its points since.
std::vector<Handle> control_handles(const Scenario& scenario, const Snapshot& snapshot);
/// The scenario with a handle's place moved: beyond the border of a periodic plane it comes in at the other
/// side, at a wall it stays.
Scenario with_handle_at(const Scenario& scenario, const Handle& handle, Vec3 place);

/// The position of a handle in a scene; nothing on the far side of a globe, or if only xi is shown.
std::optional<Pixel> pixel_of(const Handle& handle, const PlannedView& shown);
/// The place of a handle for a pixel; for pixels beside a globe the nearest point of its limb,
/// beside a projection nothing.
std::optional<Vec3> place_under(const Handle& handle, const PlannedView& shown, Pixel pixel);

void draw_handle(const Handle& handle, ImDrawList& list, ImVec2 at, bool lit, const Theme& theme,
                 float scale);
/// "handle.center_x", "handle.control_points.3"
std::string item_name(const Handle& handle);

} // namespace gaspard
