// An image in memory, and PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// 8-bit sRGB with alpha, rows from top to bottom.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Throws MachineError if the file cannot be written.
void write_png(const std::filesystem::path& file, const Image& image, double dpi = 0);
/// Throws InputError if the file cannot be read or decoded.
Image read_image(const std::filesystem::path& file);
/// The same of the bytes of a file; `name` stands in messages.
Image decode_png(std::string_view bytes, const std::string& name);

} // namespace gaspard
