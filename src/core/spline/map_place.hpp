// F at a point with its derivatives, and the element of area or volume J of core/spline/patch_map.hpp from
// them:
//
//   surface   N = F_1 x F_2,           J = |N|,   J_k = N . N_k / J
//   solid     d = F_1 . (F_2 x F_3),   J = |d|,   J_k = sign(d) d_k
#pragma once

#include "core/base/points.hpp"

#include <array>
#include <cstddef>

namespace gaspard {

template <std::size_t D>
struct Place {
    Vec3 x;
    std::array<Vec3, D> first{};              ///< F_1, F_2 (, F_3)
    std::array<Vec3, D*(D + 1) / 2> second{}; ///< F_11, F_12, F_22, or F_11, F_12, F_13, F_22, F_23, F_33
};

struct Element {
    double value = 0;
    Vec3 gradient; ///< of J; zero where J = 0
};

inline double element_of(const Place<2>& f) { return norm(cross(f.first[0], f.first[1])); }
inline double element_of(const Place<3>& f) {
    return std::abs(dot(cross(f.first[0], f.first[1]), f.first[2]));
}

inline Element element_with_gradient(const Place<2>& f) {
    const auto& [f1, f2] = f.first;
    const auto& [f11, f12, f22] = f.second;
    const Vec3 normal = cross(f1, f2);
    const double value = norm(normal);
    const Vec3 unit = value > 0 ? (1 / value) * normal : Vec3{};
    return {value,
            {dot(unit, cross(f11, f2) + cross(f1, f12)), dot(unit, cross(f12, f2) + cross(f1, f22)), 0}};
}
inline Element element_with_gradient(const Place<3>& f) {
    const auto& [f1, f2, f3] = f.first;
    const auto& [f11, f12, f13, f22, f23, f33] = f.second;
    const Vec3 c1 = cross(f2, f3), c2 = cross(f3, f1), c3 = cross(f1, f2);
    const double value = dot(f1, c1);
    const double sign = value > 0 ? 1 : value < 0 ? -1 : 0;
    const Vec3 gradient{dot(f11, c1) + dot(f12, c2) + dot(f13, c3),
                        dot(f12, c1) + dot(f22, c2) + dot(f23, c3),
                        dot(f13, c1) + dot(f23, c2) + dot(f33, c3)};
    return {sign * value, sign * gradient};
}

} // namespace gaspard
