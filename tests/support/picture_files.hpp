// PNG and JPEG files of all kinds, written by libpng and libjpeg.
#pragma once

#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <jpeglib.h>
#include <png.h>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {

struct PngKind {
    int width = 0, height = 0, bits = 8, color = PNG_COLOR_TYPE_GRAY;
    bool interlaced = false;
    std::vector<png_color> palette{};
    std::vector<std::uint8_t> transparency{}; ///< of the palette's colours
};

/// `rows`: packed as in the file.
inline std::string png_bytes(const PngKind& kind, std::vector<std::vector<std::uint8_t>> rows) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp p, png_bytep data, std::size_t n) {
            static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), n);
        },
        [](png_structp) {});
    png_set_IHDR(png, info, static_cast<png_uint_32>(kind.width), static_cast<png_uint_32>(kind.height),
                 kind.bits, kind.color, kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!kind.palette.empty())
        png_set_PLTE(png, info, kind.palette.data(), static_cast<int>(kind.palette.size()));
    if (!kind.transparency.empty())
        png_set_tRNS(png, info, kind.transparency.data(), static_cast<int>(kind.transparency.size()),
                     nullptr);
    png_set_gAMA(png, info, 0.3); // must change nothing
    std::vector<png_bytep> pointers;
    for (auto& row : rows) pointers.push_back(row.data());
    png_set_rows(png, info, pointers.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

struct JpegKind {
    int width = 0, height = 0;
    J_COLOR_SPACE color = JCS_GRAYSCALE; ///< of the rows
    J_COLOR_SPACE stored = JCS_UNKNOWN;  ///< of the file; unknown: the default
    bool progressive = false;
    std::vector<std::uint8_t> exif{}; ///< APP1
};

inline std::string jpeg_bytes(const JpegKind& kind, std::vector<std::vector<std::uint8_t>> rows) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &memory, &size);
    jpeg.image_width = static_cast<JDIMENSION>(kind.width),
    jpeg.image_height = static_cast<JDIMENSION>(kind.height);
    jpeg.input_components = static_cast<int>(rows.front().size()) / kind.width;
    jpeg.in_color_space = kind.color;
    jpeg_set_defaults(&jpeg);
    if (kind.stored != JCS_UNKNOWN) jpeg_set_colorspace(&jpeg, kind.stored);
    jpeg_set_quality(&jpeg, 98, TRUE);
    if (kind.progressive) jpeg_simple_progression(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    if (!kind.exif.empty())
        jpeg_write_marker(&jpeg, JPEG_APP0 + 1, kind.exif.data(), static_cast<unsigned>(kind.exif.size()));
    for (auto& row : rows) {
        unsigned char* pointer = row.data();
        jpeg_write_scanlines(&jpeg, &pointer, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    std::string bytes(reinterpret_cast<const char*>(memory), size);
    std::free(memory);
    return bytes;
}

} // namespace gaspard
