#include "core/scenario/view_directions.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

static ViewDirection home_direction() {
    const double azimuth = 0.6, elevation = 0.45; // radians, of the viewer as seen from the mesh
    return {"home",
            "Home",
            "Show the whole mesh.",
            {-std::sin(azimuth), std::cos(azimuth), 0},
            {-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
             std::cos(elevation)}};
}

std::span<const ViewDirection> view_directions() {
    static const ViewDirection rows[] = {
        home_direction(),
        {"front", "Front view", "View a mesh in space from the front, along +y.", {1, 0, 0}, {0, 0, 1}},
        {"back", "Back view", "View a mesh in space from the back, along −y.", {-1, 0, 0}, {0, 0, 1}},
        {"left", "Left view", "View a mesh in space from the left, along +x.", {0, -1, 0}, {0, 0, 1}},
        {"right", "Right view", "View a mesh in space from the right, along −x.", {0, 1, 0}, {0, 0, 1}},
        {"top", "Top view", "View a mesh in space from above, along −z.", {1, 0, 0}, {0, 1, 0}},
        {"bottom", "Bottom view", "View a mesh in space from below, along +z.", {1, 0, 0}, {0, -1, 0}},
    };
    return rows;
}

const ViewDirection& view_direction(std::string_view name) {
    const auto rows = view_directions();
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
    GASPARD_CHECK(found != rows.end());
    return *found;
}

} // namespace gaspard
