// The standard directions from which a mesh in space is viewed: the choices of view.direction, the window's
// keys 1 to 6, and the axes of their cameras.
#pragma once

#include "core/base/points.hpp"

#include <span>
#include <string_view>

namespace gaspard {

struct ViewDirection {
    std::string_view name;  ///< as in view.direction: "front"
    std::string_view label; ///< "Front view"
    std::string_view help;  ///< one sentence
    Vec3 right, up;         ///< world directions that point right and up in the image; orthonormal
};

/// "home" (from slightly above) first, then the six sides; z points up.
std::span<const ViewDirection> view_directions();
/// The one of this name, which must exist.
const ViewDirection& view_direction(std::string_view name);

} // namespace gaspard
