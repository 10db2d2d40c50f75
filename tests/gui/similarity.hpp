// How alike two pictures look: a measure that forgives what drivers round differently, but not what the eye
// sees.
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

/// Pictures of different sizes have nothing in common.
Similarity compare(const Image& a, const Image& b);
/// Empty if they look the same, else what is different.
std::string difference(const Image& a, const Image& b);

} // namespace gaspard
