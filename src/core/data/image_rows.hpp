// What the decoders of pictures share: rows of grey values come from the top, and are averaged as they come.
#pragma once

#include "core/data/image.hpp"

#include <cstdint>
#include <span>

namespace gaspard {

struct DecodeContext {
    std::string_view bytes;
    const std::string& name;
    std::size_t longest;
    const std::function<void(double)>& progress;
    const std::stop_token& stop;
};

/// Throws the InputError "cannot read NAME: WHY".
[[noreturn]] void refuse_image(const std::string& name, const std::string& why);
/// Throws InputError if there are no pixels or too many.
void check_image_size(const std::string& name, std::size_t width, std::size_t height);

/// Averages blocks of k x k pixels; blocks at the right and at the bottom may be smaller.
class ImageRows {
  public:
    /// The picture as it is decoded; `full_width`, `full_height`: that of the file.
    ImageRows(const DecodeContext& context, std::size_t width, std::size_t height, std::size_t full_width,
              std::size_t full_height);
    /// The next row, `width` values. Throws Interrupted if asked to stop.
    void add(std::span<const float> grey);
    GreyImage take(std::string format);

  private:
    void finish_block();

    const DecodeContext& context_;
    std::size_t width_, height_, block_, rows_ = 0;
    std::vector<float> sums_;
    GreyImage image_;
};

/// `orientation`: 1 to 8 as in EXIF; others change nothing.
GreyImage upright(GreyImage image, int orientation);
/// The orientation in an EXIF block (the content of APP1 after "Exif\0\0"); 1 if there is none.
int exif_orientation(std::span<const std::uint8_t> exif);

GreyImage decode_png(const DecodeContext& context);
GreyImage decode_jpeg(const DecodeContext& context);

} // namespace gaspard
