// How far apart two points of a domain are, which is what a monitor with a centre needs to know of it.
#pragma once

#include "core/base/points.hpp"

namespace gaspard {

enum class SpaceKind {
    euclidean,       ///< straight lines in R^3
    periodic_square, ///< the flat torus R^2/Z^2: the nearest image counts
};

struct Space {
    SpaceKind kind = SpaceKind::euclidean;
};

/// The shortest vector from `from` to `to`.
Vec3 displacement(const Space& space, Vec3 from, Vec3 to);

} // namespace gaspard
