// Pictures as plain data: PNG and JPEG, read by what the bytes are and not by the name of the file.
//
//   PNG    1, 2, 4, 8 and 16 bits; grey, palette, RGB, with and without alpha or transparency, interlaced
//   JPEG   grey, YCbCr, RGB, CMYK and YCCK; sequential and progressive; turned as its EXIF orientation says
//
// Only the brightness is kept, of the numbers as they are stored (gamma and colour profiles are not applied):
// 0.299 R + 0.587 G + 0.114 B, and transparent pixels over white.
#pragma once

#include "core/base/export.hpp"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

/// The brightness of a picture.
struct GreyImage {
    std::size_t width = 0, height = 0;
    std::vector<float> grey; ///< 0 black to 1 white; width x height, by rows from the top
    /// Size of the picture in the file, upright; the image is its reduction by whole pixels.
    std::size_t full_width = 0, full_height = 0;
    std::string format; ///< "PNG" or "JPEG"
};

/// The largest picture that is read: 200 megapixels, and pixels along a side.
inline constexpr std::size_t most_pixels = 200'000'000;
inline constexpr std::size_t most_pixels_of_a_side = 65'535;

/// Reduces the picture to at most `longest` pixels along each side, as averages of k x k pixels. `name`
/// stands in messages. Throws InputError for other formats, which it names, for damaged and incomplete
/// pictures and for those that are too large; Interrupted if asked to stop. `progress`: the fraction done.
GreyImage decode_image(std::string_view bytes, const std::string& name, std::size_t longest = 2048,
                       const std::function<void(double)>& progress = {}, const std::stop_token& stop = {});

} // namespace GASPARD_API
