#include "gui/app/window_icon.hpp"

#include "core/base/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

constexpr double icon_radius = 0.22; // of the circle
constexpr Vec3 icon_ground{0x1b, 0x1f, 0x2a}, icon_ring{0x31, 0x68, 0x8e}, icon_lines{0xfd, 0xe7, 0x25};

/// The computational coordinates at a point of the square: they change fastest across the circle.
Vec3 icon_xi(Vec3 p) {
    const Vec3 away = p - Vec3{0.5, 0.5, 0};
    const double r = norm(away);
    if (r < 1e-9 || r > 0.5) return p;
    const double bump =
        0.055 * std::tanh((r - icon_radius) / 0.07) * std::min(1.0, 5 * (0.5 - r)) * std::min(1.0, r / 0.2);
    return p + (bump / r) * away;
}

/// How much of a line of this width a value with spacing 1 between lines is in.
double line_at(double value, double width) {
    const double distance = std::abs(value - std::round(value));
    return std::clamp(1.5 - distance / width, 0.0, 1.0);
}

/// Inside a square with round corners, from 0 to 1 over a pixel.
double inside_square(Vec3 p, double pixel) {
    constexpr double half = 0.47, corner = 0.14;
    const double x = std::max(std::abs(p.x - 0.5) - half + corner, 0.0),
                 y = std::max(std::abs(p.y - 0.5) - half + corner, 0.0);
    return std::clamp((corner - std::hypot(x, y)) / pixel + 0.5, 0.0, 1.0);
}

} // namespace

Image window_icon(int size) {
    Image image{size, size, {}};
    const double pixel = 1.0 / size;
    const double icon_cells = size < 32 ? 4 : 8; // per side
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const Vec3 p{(column + 0.5) * pixel, (row + 0.5) * pixel, 0};
            const double r = std::hypot(p.x - 0.5, p.y - 0.5);
            const double ring = 0.6 * std::exp(-std::pow((r - icon_radius) / 0.06, 2));
            Vec3 colour = (1 - ring) * icon_ground + ring * icon_ring;
            const Vec3 margin = 1 / 0.84 * (p - Vec3{0.08, 0.08, 0}); // the mesh leaves a margin
            const Vec3 xi = icon_cells * icon_xi(margin);
            const double width = std::max(0.7 * icon_cells * pixel, 0.05);
            const bool in_mesh = std::max(std::abs(margin.x - 0.5), std::abs(margin.y - 0.5)) < 0.5 + pixel;
            const double line = in_mesh ? std::max(line_at(xi.x, width), line_at(xi.y, width)) : 0;
            colour = (1 - line) * colour + line * icon_lines;
            for (const double part : {colour.x, colour.y, colour.z, 255 * inside_square(p, pixel)})
                image.rgba.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 255.0))));
        }
    return image;
}

} // namespace gaspard
