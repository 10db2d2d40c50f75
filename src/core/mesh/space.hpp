// How distances between points of a domain are measured; monitors with a centre depend on it.
#pragma once

#include "core/base/points.hpp"

#include <string_view>

namespace gaspard {

enum class SpaceKind {
    euclidean,       ///< distances in R^3
    periodic_square, ///< the flat torus R^2/Z^2: distance to the nearest image
    sphere,          ///< a sphere around the origin: angles between directions, in radians
};

struct Space {
    SpaceKind kind = SpaceKind::euclidean;
};

/// Name for messages: "a periodic square".
std::string_view name_of(SpaceKind kind);

/// The shortest vector from `from` to `to`, over all periodic images; on the sphere the chord.
Vec3 displacement(const Space& space, Vec3 from, Vec3 to);

/// The point of the unit sphere at a latitude and longitude in degrees.
Vec3 at_latitude_longitude(double latitude, double longitude);
/// The angle between two nonzero vectors of any length, in [0, pi].
double angle_between(Vec3 a, Vec3 b);

} // namespace gaspard
