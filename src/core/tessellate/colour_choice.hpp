// What cells are to be coloured by, in an image or a file; the names are explained in
// tessellate/colouring.hpp.
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"

#include <string>

namespace gaspard GASPARD_API {

struct ColourChoice {
    std::string colouring = "monitor"; ///< of mesh_colours(), a field of the method, or none
    std::string map = "automatic";     ///< or a name of colour_maps(): the one that suits the values
    bool logarithmic = false;          ///< where values may be negative (equidistribution) it stays linear
    bool fixed = false;                ///< the range is low to high, else it follows the values
    double low = 0, high = 1;
    int contours = 0; ///< at most so many levels of contour lines
    friend bool operator==(const ColourChoice&, const ColourChoice&) = default;
};
/// `view`: values of view_rows().
ColourChoice colour_choice(const Values& view);

} // namespace GASPARD_API
