#include "gui/gl/picture_sheet.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

constexpr int between = 1; // pixels left free, so that interpolation does not mix neighbours

} // namespace

PictureSheet::PictureSheet(int width, int height, int count)
    : width_(width), height_(height),
      columns_(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count) * height / width)))),
      count_(count) {
    GASPARD_CHECK(width > 0 && height > 0 && count > 0);
    const int rows = (count + columns_ - 1) / columns_;
    image_.width = columns_ * (width + between), image_.height = rows * (height + between);
    image_.rgba.resize(4 * static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height));
}

PicturePlace PictureSheet::add(const Image& picture) {
    GASPARD_CHECK(picture.width == width_ && picture.height == height_ && added_ < count_);
    const int left = added_ % columns_ * (width_ + between), top = added_ / columns_ * (height_ + between);
    ++added_;
    const auto row = 4 * static_cast<std::ptrdiff_t>(width_);
    for (int y = 0; y < height_; ++y) {
        const auto from = picture.rgba.begin() + y * row;
        std::copy(from, from + row,
                  image_.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * image_.width + left));
    }
    const auto across = [&](int x) { return static_cast<float>(x) / static_cast<float>(image_.width); };
    const auto down = [&](int y) { return static_cast<float>(y) / static_cast<float>(image_.height); };
    return {this, {across(left), down(top)}, {across(left + width_), down(top + height_)}};
}

} // namespace gaspard
