// How far apart two points of a domain are, which is what a monitor with a centre needs to know of it.
#pragma once

#include "core/base/points.hpp"

#include <string_view>

namespace gaspard {

enum class SpaceKind {
    euclidean,       ///< straight lines in R^3
    periodic_square, ///< the flat torus R^2/Z^2: the nearest image counts
    sphere,          ///< the surface of a sphere around the origin: angles seen from there, in radians
};

struct Space {
    SpaceKind kind = SpaceKind::euclidean;
};

/// As in "a function of a periodic square".
std::string_view name_of(SpaceKind kind);

/// The shortest vector from `from` to `to`; on the sphere straight through space.
Vec3 displacement(const Space& space, Vec3 from, Vec3 to);

/// The point of the unit sphere at a latitude and longitude in degrees.
Vec3 at_latitude_longitude(double latitude, double longitude);
/// The angle between two directions, from 0 to pi; of any length but 0.
double angle_between(Vec3 a, Vec3 b);

} // namespace gaspard
