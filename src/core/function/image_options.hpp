// How a picture becomes a function on a domain (function/image_function.hpp) or a monitor
// (monitor/image_monitor.hpp).
#pragma once

#include "core/base/export.hpp"

namespace gaspard GASPARD_API {

enum class ImageFit {
    fit,     ///< all of the picture, in the middle
    fill,    ///< the picture covers the box; what is too large is cut off
    stretch, ///< width and height are those of the box
};
enum class LengthUnit { cells, pixels };

struct ImageOptions {
    bool invert = false;
    double gamma = 1;
    double floor = 0;
    double blur = 1; ///< sigma; at least `least_blur` cells
    LengthUnit blur_unit = LengthUnit::cells;
    ImageFit fit = ImageFit::fill;
    double left_longitude = -180; ///< of the picture's left edge, in degrees
};

/// The least blur, in cells of the uniform mesh. Monitors may need more (monitor/image_monitor.hpp).
inline constexpr double least_blur = 1;

} // namespace GASPARD_API
