#include "core/mesh/space.hpp"

#include <numbers>

namespace gaspard {

std::string_view name_of(SpaceKind kind) {
    switch (kind) {
    case SpaceKind::periodic_square:
        return "a periodic square";
    case SpaceKind::sphere:
        return "a sphere";
    case SpaceKind::euclidean:
        break;
    }
    return "Euclidean space";
}

Vec3 displacement(const Space& space, Vec3 from, Vec3 to) {
    Vec3 d = to - from;
    if (space.kind == SpaceKind::periodic_square) {
        d.x -= std::round(d.x);
        d.y -= std::round(d.y);
    }
    return d;
}

Vec3 at_latitude_longitude(double latitude, double longitude) {
    constexpr double degree = std::numbers::pi / 180;
    const double level = std::cos(latitude * degree);
    return {level * std::cos(longitude * degree), level * std::sin(longitude * degree),
            std::sin(latitude * degree)};
}

double angle_between(Vec3 a, Vec3 b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

} // namespace gaspard
