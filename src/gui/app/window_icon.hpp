// The icon of the window, drawn for any size: a mesh that is dense around a circle, as in
// packaging/gaspard.svg.
#pragma once

#include "core/io/image.hpp"

namespace gaspard {

/// A square of so many pixels.
Image window_icon(int size);

} // namespace gaspard
