#include "core/mesh/space.hpp"

namespace gaspard {

Vec3 displacement(const Space& space, Vec3 from, Vec3 to) {
    Vec3 d = to - from;
    if (space.kind == SpaceKind::periodic_square) {
        d.x -= std::round(d.x);
        d.y -= std::round(d.y);
    }
    return d;
}

} // namespace gaspard
