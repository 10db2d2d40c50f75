#include "core/base/check.hpp"
#include "core/base/read_file.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/image.hpp"
#include "core/io/png_chunks.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <stb_image.h>
#include <stb_image_write.h> // Debian's libstb holds the implementations
#include <string>

namespace gaspard {

namespace {

/// The chunk with the resolution.
std::string phys_chunk(double dpi) {
    const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
    std::string content;
    append_big_endian(content, per_metre);
    append_big_endian(content, per_metre);
    return png_chunk("pHYs", content + '\1'); // the unit is the metre
}

} // namespace

void write_png(const std::filesystem::path& file, const Image& image, double dpi) {
    GASPARD_CHECK(image.width > 0 && image.height > 0);
    GASPARD_CHECK(image.rgba.size() ==
                  4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    std::string bytes;
    const auto append = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    const int done = stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(),
                                            4 * image.width);
    GASPARD_CHECK(done != 0);
    constexpr std::size_t after_header = 8 + 25; // the signature and IHDR
    if (dpi > 0) bytes.insert(after_header, phys_chunk(dpi));
    write_atomically(file, bytes);
}

Image read_image(const std::filesystem::path& file) { return decode_png(read_file(file), file.string()); }

Image decode_png(std::string_view bytes, const std::string& name) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw InputError("cannot read the image " + name + ": it is larger than 2 GiB");
    Image image;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &image.width, &image.height, nullptr, 4),
        &stbi_image_free);
    if (!pixels) throw InputError("cannot read the image " + name + ": " + stbi_failure_reason());
    const auto count = 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgba.assign(pixels.get(), pixels.get() + count);
    return image;
}

} // namespace gaspard
