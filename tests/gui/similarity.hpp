// The similarity of two images: a measure that ignores differences in rounding between drivers, but not
// visible ones.
#pragma once

#include "core/io/image.hpp"

#include <string>

namespace gaspard {

struct Similarity {
    double mean_difference = 255; ///< of colours in blocks of 4 x 4 pixels, 0 to 255
    double worst_structure =
        -1; ///< structural similarity of brightness, of the worst of 10 x 10 parts; 1 is equal
    double mean_structure = -1; ///< the same, mean of all parts
};

/// Images of different sizes have similarity zero.
Similarity compare(const Image& a, const Image& b);
/// Empty if they look the same, else what is different.
std::string difference(const Image& a, const Image& b);

} // namespace gaspard
