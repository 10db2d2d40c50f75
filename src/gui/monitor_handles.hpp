// The places of a monitor that the mouse can drag: centres and poles, as far as its values have any. On the
// plane they are values "..._x" and "..._y", on a sphere "..._latitude" and "..._longitude" in degrees.
#pragma once

#include "core/scenario/scenario.hpp"
#include "gui/viewport.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

struct MonitorHandle {
    std::string first, second; ///< keys: x and y, or latitude and longitude
    bool on_sphere = false;
    Vec3 place; ///< in the plane, or of unit length
};

std::vector<MonitorHandle> monitor_handles(const Scenario& scenario);
/// The scenario with a handle's place moved: beyond the border of a periodic plane it comes in at the other
/// side, at a wall it stays.
Scenario with_handle_at(const Scenario& scenario, const MonitorHandle& handle, Vec3 place);

/// Where a picture shows a handle; nothing on the far side of a globe, or where only xi is shown.
std::optional<Pixel> pixel_of(const MonitorHandle& handle, const PlannedPicture& shown);
/// The place that a pixel means for a handle; of what lies beside a globe the nearest point of its limb,
/// beside a map nothing.
std::optional<Vec3> place_under(const MonitorHandle& handle, const PlannedPicture& shown, Pixel pixel);

void draw_handle(ImDrawList& list, ImVec2 at, bool lit, const Theme& theme, float scale);

} // namespace gaspard
