// Large images are drawn in horizontal strips, so that the buffers of OpenGL, which take some 50 bytes a
// pixel, stay below 200 MB whatever the size of the image.
#pragma once

#include "core/io/image.hpp"
#include "core/tessellate/camera.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/render/mesh_renderer.hpp"

#include <functional>
#include <imgui.h>
#include <optional>

namespace gaspard {

/// Rows of an image, counted from its top.
struct Strip {
    int top = 0, height = 0;
};

/// The height of the strips of an image; all but the last one have it. Images of up to `most_pixels` are one
/// strip.
int strip_height(int width, int height, int most_pixels = strip_pixels);

/// An image put together from strips of this height; `draw` returns one of them, which may go on below the
/// image.
Image draw_in_strips(int width, int height, int step, const std::function<Image(Strip)>& draw);

/// The part of a view that a strip shows, in the strip's pixels.
struct StripView {
    Camera camera;
    PixelRect area;
};
/// `area` is where the whole view is in the image; nullopt if it lies outside of the strip.
std::optional<StripView> in_strip(const Camera& camera, PixelRect area, Strip strip);

/// What ImGui draws in a strip of an image with one pixel a unit. Refers to the lists of `data`.
ImDrawData in_strip(const ImDrawData& data, Strip strip);

} // namespace gaspard
