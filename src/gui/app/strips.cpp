#include "gui/app/strips.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cstddef>

namespace gaspard {

int strip_height(int width, int height, int most_pixels) {
    return std::clamp(most_pixels / std::max(width, 1), 1, std::max(height, 1));
}

Image draw_in_strips(int width, int height, int step, const std::function<Image(Strip)>& draw) {
    if (step == height) return draw({0, height});
    Image whole{width, height, {}};
    whole.rgba.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int top = 0; top < height; top += step) {
        const Strip strip{top, std::min(step, height - top)};
        const Image part = draw(strip);
        GASPARD_CHECK(part.width == width && part.height >= strip.height);
        const auto bytes = 4 * static_cast<std::ptrdiff_t>(width) * strip.height;
        whole.rgba.insert(whole.rgba.end(), part.rgba.begin(), part.rgba.begin() + bytes);
    }
    return whole;
}

std::optional<StripView> in_strip(const Camera& camera, PixelRect area, Strip strip) {
    const int top = std::max(area.y, strip.top);
    const int bottom = std::min(area.y + area.height, strip.top + strip.height);
    if (bottom <= top) return std::nullopt;
    const PixelRect part{area.x, top - strip.top, area.width, bottom - top};
    if (part.height == area.height) return StripView{camera, part}; // to the last bit
    Camera panned = camera;
    panned.centre = to_world(camera, area.size(), {area.size().width / 2, (top + bottom) / 2.0 - area.y});
    return StripView{panned, part};
}

ImDrawData in_strip(const ImDrawData& data, Strip strip) {
    ImDrawData part = data;
    part.DisplayPos.y += static_cast<float>(strip.top);
    part.DisplaySize.y = static_cast<float>(strip.height);
    return part;
}

} // namespace gaspard
