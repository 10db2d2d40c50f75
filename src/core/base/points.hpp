// Points in space, one array per coordinate, so that loops over many points access memory contiguously.
#pragma once

#include "core/base/export.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace gaspard GASPARD_API {

struct Vec3 {
    double x = 0, y = 0, z = 0;

    friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }
/// A unit vector orthogonal to the given unit vector.
inline Vec3 any_across(Vec3 unit) {
    const Vec3 away = std::abs(unit.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 across = away - dot(away, unit) * unit;
    return (1 / norm(across)) * across;
}

/// n points in R^3 (z = 0 in the plane, y = z = 0 on a line).
struct Points {
    std::vector<double> x, y, z;

    Points() = default;
    explicit Points(std::size_t n) : x(n), y(n), z(n) {}

    std::size_t size() const { return x.size(); }
    void resize(std::size_t n) { x.resize(n), y.resize(n), z.resize(n); }
    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, Vec3 p) { x[i] = p.x, y[i] = p.y, z[i] = p.z; }
    friend bool operator==(const Points&, const Points&) = default;
};

/// Pointwise difference; both arguments have the same size.
inline Points operator-(const Points& a, const Points& b) {
    Points difference(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) difference.set(i, a[i] - b[i]);
    return difference;
}

} // namespace GASPARD_API
