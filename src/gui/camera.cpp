#include "gui/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

Vec3 minimum(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 maximum(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// Sets centre and scale so that the box, seen along the camera's axes, fills what the insets leave free.
void fit(Camera& camera, const Box& box, Size size, Insets insets) {
    constexpr double margin = 0.04; // of the free room, at each side
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double left = infinity, right = -infinity, bottom = infinity, top = -infinity;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                     (corner & 4) != 0 ? box.high.z : box.low.z};
        left = std::min(left, dot(camera.right, p)), right = std::max(right, dot(camera.right, p));
        bottom = std::min(bottom, dot(camera.up, p)), top = std::max(top, dot(camera.up, p));
    }
    const double free_width = std::max(1.0, size.width - insets.left - insets.right) * (1 - 2 * margin);
    const double free_height = std::max(1.0, size.height - insets.top - insets.bottom) * (1 - 2 * margin);
    camera.scale = std::max((right - left) / free_width, (top - bottom) / free_height);
    if (!(camera.scale > 0)) camera.scale = 1 / std::min(free_width, free_height);
    camera.centre = box.centre();
    pan(camera, {(insets.left - insets.right) / 2, (insets.top - insets.bottom) / 2});
}

} // namespace

Box bounding_box(const Points& points) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = points[i];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
        box.low = minimum(box.low, p), box.high = maximum(box.high, p);
    }
    return box.low.x <= box.high.x ? box : Box{};
}

Box merge(const Box& a, const Box& b) { return {minimum(a.low, b.low), maximum(a.high, b.high)}; }

Camera planar_home(const Box& box, Size size, Insets insets) {
    Camera camera;
    fit(camera, box, size, insets);
    return camera;
}

Camera spatial_home(const Box& box, Size size, Insets insets) {
    constexpr double azimuth = 0.6, elevation = 0.45; // radians, of the viewer as seen from the box
    Camera camera;
    camera.right = {-std::sin(azimuth), std::cos(azimuth), 0};
    camera.up = {-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
                 std::cos(elevation)};
    fit(camera, box, size, insets);
    return camera;
}

Camera home(const Box& box, Size size, Insets insets) {
    return box.high.z > box.low.z ? spatial_home(box, size, insets) : planar_home(box, size, insets);
}

Pixel to_pixel(const Camera& camera, Size size, Vec3 world) {
    const Vec3 from_centre = world - camera.centre;
    return {size.width / 2 + dot(camera.right, from_centre) / camera.scale,
            size.height / 2 - dot(camera.up, from_centre) / camera.scale};
}

Vec3 to_world(const Camera& camera, Size size, Pixel pixel) {
    const double x = (pixel.x - size.width / 2) * camera.scale,
                 y = (size.height / 2 - pixel.y) * camera.scale;
    return camera.centre + x * camera.right + y * camera.up;
}

void pan(Camera& camera, Pixel by) {
    camera.centre = camera.centre - (by.x * camera.scale) * camera.right + (by.y * camera.scale) * camera.up;
}

void zoom(Camera& camera, Size size, Pixel fixed, double factor, const Box& box) {
    const double extent = std::max(box.size(), norm(box.centre()));
    const double finest = 1e-12 * (extent > 0 ? extent : 1), coarsest = 10 * (extent > 0 ? extent : 1);
    const Vec3 under = to_world(camera, size, fixed);
    camera.scale =
        std::clamp(camera.scale / factor, std::min(finest, camera.scale), std::max(coarsest, camera.scale));
    camera.centre = camera.centre + under - to_world(camera, size, fixed);
}

glm::mat4 clip_matrix(const Camera& camera, Size size, Vec3 origin, double depth) {
    const Vec3 towards_viewer = cross(camera.right, camera.up);
    const Vec3 shift = origin - camera.centre;
    const struct {
        Vec3 axis;
        double factor;
    } rows[3] = {{camera.right, 2 / (camera.scale * size.width)},
                 {camera.up, 2 / (camera.scale * size.height)},
                 {towards_viewer, -1 / depth}};
    glm::mat4 matrix(1.0F);
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = rows[i].factor * rows[i].axis;
        matrix[0][i] = static_cast<float>(axis.x);
        matrix[1][i] = static_cast<float>(axis.y);
        matrix[2][i] = static_cast<float>(axis.z);
        matrix[3][i] = static_cast<float>(dot(axis, shift));
    }
    return matrix;
}

} // namespace gaspard
