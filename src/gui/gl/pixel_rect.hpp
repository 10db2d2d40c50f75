// A part of an image or framebuffer in its own pixels, from the upper left corner.
#pragma once

#include "core/tessellate/camera.hpp"

#include <algorithm>

namespace gaspard {

struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
    Size size() const { return {static_cast<double>(width), static_cast<double>(height)}; }
    bool empty() const { return width <= 0 || height <= 0; }
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

inline PixelRect intersection(PixelRect a, PixelRect b) {
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

/// The smallest one around both; of one that is empty, the other.
inline PixelRect around(PixelRect a, PixelRect b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

} // namespace gaspard
