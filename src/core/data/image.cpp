#include "core/data/image.hpp"

#include "core/base/error.hpp"
#include "core/data/image_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

using namespace std::string_view_literals;

/// The name of another format that the bytes have; empty if it is not known.
std::string other_format(std::string_view bytes) {
    struct Sign {
        std::size_t at;
        std::string_view text, name;
    };
    constexpr std::array signs{
        Sign{0, "GIF8"sv, "a GIF"sv},         Sign{8, "WEBP"sv, "a WebP"sv},
        Sign{0, "II*\0"sv, "a TIFF"sv},       Sign{0, "MM\0*"sv, "a TIFF"sv},
        Sign{4, "ftypavif"sv, "an AVIF"sv},   Sign{4, "ftyphei"sv, "a HEIC"sv},
        Sign{4, "ftyphev"sv, "a HEIC"sv},     Sign{4, "ftypmif1"sv, "a HEIC"sv},
        Sign{0, "BM"sv, "a BMP"sv},           Sign{0, "\0\0\1\0"sv, "an icon (ICO)"sv},
        Sign{0, "8BPS"sv, "a Photoshop"sv},   Sign{0, "\0\0\0\x0cjP  "sv, "a JPEG 2000"sv},
        Sign{0, "\xff\x0a"sv, "a JPEG XL"sv}, Sign{0, "\0\0\0\x0cJXL "sv, "a JPEG XL"sv},
        Sign{0, "%PDF"sv, "a PDF"sv}};
    for (const Sign& sign : signs)
        if (bytes.size() > sign.at && bytes.substr(sign.at).starts_with(sign.text))
            return std::string(sign.name);
    const std::string_view head = bytes.substr(0, 1024);
    const bool text = head.starts_with("<") || head.starts_with("\xef\xbb\xbf<");
    return text && head.find("<svg") != std::string_view::npos ? "an SVG" : "";
}

} // namespace

void refuse_image(const std::string& name, const std::string& why) {
    throw InputError("cannot read " + name + ": " + why);
}

void check_image_size(const std::string& name, std::size_t width, std::size_t height) {
    if (width == 0 || height == 0) refuse_image(name, "the picture has no pixels");
    if (std::max(width, height) > most_pixels_of_a_side)
        refuse_image(name, "the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                               " pixels; each side may have " + std::to_string(most_pixels_of_a_side));
    if (width > most_pixels / height)
        refuse_image(name, "the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                               " pixels; at most " + std::to_string(most_pixels / 1'000'000) +
                               " megapixels are allowed");
}

ImageRows::ImageRows(const DecodeContext& context, std::size_t width, std::size_t height,
                     std::size_t full_width, std::size_t full_height)
    : context_(context), width_(width), height_(height),
      block_((std::max(width, height) + context.longest - 1) / context.longest) {
    image_.width = (width + block_ - 1) / block_, image_.height = (height + block_ - 1) / block_;
    image_.full_width = full_width, image_.full_height = full_height;
    image_.grey.reserve(image_.width * image_.height);
    sums_.assign(image_.width, 0.0F);
}

void ImageRows::add(std::span<const float> grey) {
    if (context_.stop.stop_requested()) throw Interrupted();
    for (std::size_t i = 0, at = 0; i < image_.width; ++i) {
        const std::size_t end = std::min(at + block_, width_);
        float sum = 0;
        for (; at < end; ++at) sum += grey[at];
        sums_[i] += sum;
    }
    ++rows_;
    if (rows_ % block_ == 0 || rows_ == height_) finish_block();
    if (context_.progress && rows_ % 64 == 0)
        context_.progress(static_cast<double>(rows_) / static_cast<double>(height_));
}

void ImageRows::finish_block() {
    const std::size_t down = rows_ - (rows_ - 1) / block_ * block_;
    for (std::size_t i = 0; i < image_.width; ++i) {
        const std::size_t across = std::min(block_, width_ - i * block_);
        const float mean = sums_[i] / static_cast<float>(across * down);
        image_.grey.push_back(std::clamp(mean, 0.0F, 1.0F));
        sums_[i] = 0;
    }
}

GreyImage ImageRows::take(std::string format) {
    image_.format = std::move(format);
    return std::move(image_);
}

GreyImage upright(GreyImage image, int orientation) {
    if (orientation < 2 || orientation > 8) return image;
    // Where the first row and the first column of the file are in the upright picture (EXIF 2.3, 4.6.4).
    const bool turned = orientation >= 5; // rows become columns
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    GreyImage result = image;
    if (turned) {
        std::swap(result.width, result.height);
        std::swap(result.full_width, result.full_height);
    }
    for (std::size_t y = 0; y < result.height; ++y)
        for (std::size_t x = 0; x < result.width; ++x) {
            const std::size_t across = from_right ? result.width - 1 - x : x;
            const std::size_t down = from_bottom ? result.height - 1 - y : y;
            const std::size_t row = turned ? across : down, column = turned ? down : across;
            result.grey[y * result.width + x] = image.grey[row * image.width + column];
        }
    return result;
}

int exif_orientation(std::span<const std::uint8_t> exif) {
    if (exif.size() < 8) return 1;
    const bool little = exif[0] == 'I';
    const auto number = [&](std::size_t at, std::size_t bytes) -> std::size_t {
        std::size_t value = 0;
        if (at > exif.size() || exif.size() - at < bytes) return 0;
        for (std::size_t k = 0; k < bytes; ++k) value = value << 8 | exif[at + (little ? bytes - 1 - k : k)];
        return value;
    };
    if (number(2, 2) != 42) return 1;
    const std::size_t folder = number(4, 4), entries = number(folder, 2);
    for (std::size_t k = 0; k < entries; ++k) {
        const std::size_t entry = folder + 2 + 12 * k;
        if (entry > exif.size()) break;
        if (number(entry, 2) == 0x0112 && number(entry + 2, 2) == 3)
            return static_cast<int>(number(entry + 8, 2));
    }
    return 1;
}

GreyImage decode_image(std::string_view bytes, const std::string& name, std::size_t longest,
                       const std::function<void(double)>& progress, const std::stop_token& stop) {
    const DecodeContext context{bytes, name, std::max<std::size_t>(longest, 1), progress, stop};
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return decode_png(context);
    if (bytes.starts_with("\xff\xd8\xff"sv)) return decode_jpeg(context);
    if (bytes.empty()) refuse_image(name, "the file is empty");
    const std::string format = other_format(bytes);
    refuse_image(name, format.empty() ? "it is neither a PNG nor a JPEG picture"
                                      : "it is " + format + " file; convert it to PNG or JPEG");
}

} // namespace gaspard
