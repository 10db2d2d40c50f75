// How distances between points of a domain are measured, and where it lies; monitors depend on both.
#pragma once

#include "core/base/box.hpp"
#include "core/base/export.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

enum class SpaceKind {
    euclidean,       ///< distances in R^3
    periodic_square, ///< the flat torus R^2/Z^2: distance to the nearest image
    sphere,          ///< a sphere around the origin: angles between directions, in radians
};

struct Space {
    SpaceKind kind = SpaceKind::euclidean;
    int dimension = 2;  ///< of the Euclidean space around a patch: 3 for a surface in space, and for a solid
    bool solid = false; ///< the domain fills the space
    /// Around a domain of any size and place (a patch from a file): built-in monitors are scaled to it
    /// (monitor/placement.hpp). Without it they are those of the unit square, whatever the domain.
    std::optional<Box> box{};
    /// With a box: a point of the domain around which monitors are placed by default; in the plane the middle
    /// of the box.
    Vec3 middle{};
    /// Boxes that the ranges of centres and lengths have to cover in any case.
    std::vector<Box> reach{};
    /// Of a quadrilateral, anticlockwise from the lower left; empty: other domains.
    std::vector<Vec3> corners{};
    /// The image of the parameter square of a patch: formulas may use its parameters u and v.
    bool patch = false;
    friend bool operator==(const Space&, const Space&) = default;
};

/// Name for messages: "a periodic square".
std::string_view name_of(SpaceKind kind);

/// The shortest vector from `from` to `to`, over all periodic images; on the sphere the chord.
Vec3 displacement(const Space& space, Vec3 from, Vec3 to);

/// The point of the unit sphere at a latitude and longitude in degrees.
Vec3 at_latitude_longitude(double latitude, double longitude);
/// The angle between two nonzero vectors of any length, in [0, pi].
double angle_between(Vec3 a, Vec3 b);

} // namespace GASPARD_API
