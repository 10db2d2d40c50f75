// Places that the mouse can drag: centres and poles of a monitor, as far as its values have any (in the plane
// "..._x" and "..._y", on a sphere "..._latitude" and "..._longitude" in degrees), and of the domain the
// control points of a patch in the plane, the centres and the points of convex domains.
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
    std::shared_ptr<const Points> control{}; ///< all of the curve or patch, where this is a control point
    std::size_t number = 0;                  ///< which of them
    std::size_t columns = 0;                 ///< of the net that they are, in the first direction; 0: none
    bool of_domain = false;                  ///< keys of the domain, not of the monitor
    bool of_source = false;                  ///< of the domain from which a map goes to another one
};

/// Of the monitor, without those that the time moves unless these are asked for as well.
std::vector<Handle> monitor_handles(const Scenario& scenario, bool moving = false);
/// Of the domain: the centres of shapes; control points of the patch that a snapshot is of, or as the
/// scenario has moved them since; points of curves.
std::vector<Handle> domain_handles(const Scenario& scenario, const Snapshot& snapshot);
/// The scenario with a handle's place moved: beyond the border of a periodic plane it comes in at the other
/// side, at a wall it stays.
Scenario with_handle_at(const Scenario& scenario, const Handle& handle, Vec3 place);

/// The position of a handle in a scene; nothing on the far side of a globe, or if only xi is shown, where
/// those of the source are.
std::optional<Pixel> pixel_of(const Handle& handle, const PlannedView& shown);
/// The place of a handle for a pixel; for pixels beside a globe the nearest point of its limb,
/// beside a projection nothing.
std::optional<Vec3> place_under(const Handle& handle, const PlannedView& shown, Pixel pixel);

/// Thin lines between neighbours of the net that control points of a patch are, below the handles.
void draw_control_net(const std::vector<Handle>& handles, ImDrawList& list, const PlannedView& shown,
                      const Theme& theme, float scale);
void draw_handle(const Handle& handle, ImDrawList& list, ImVec2 at, bool lit, const Theme& theme,
                 float scale);
/// A dragged coordinate: in steps of about 1e-4 of a length, a power of ten.
double rounded_within(double span, double value);
/// "handle.center_x", "handle.control_points.3"
std::string item_name(const Handle& handle);

} // namespace gaspard
