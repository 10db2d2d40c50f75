#include "core/io/png_chunks.hpp"

#include "core/base/error.hpp"

#include <zlib.h>

namespace gaspard {

/// Of the type and the content of a chunk.
static std::uint32_t checksum(std::string_view body) {
    const auto* bytes = reinterpret_cast<const Bytef*>(body.data());
    return static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(body.size())));
}

static std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

void append_big_endian(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xffU);
}

std::string png_chunk(std::string_view type, std::string_view content) {
    std::string chunk;
    append_big_endian(chunk, static_cast<std::uint32_t>(content.size()));
    chunk += type;
    chunk += content;
    append_big_endian(chunk, checksum(std::string_view(chunk).substr(4)));
    return chunk;
}

std::vector<PngChunk> png_chunks(std::string_view bytes, const std::filesystem::path& file) {
    const auto broken = [&] {
        return MachineError("cannot read " + file.string() + ": not a complete PNG file");
    };
    if (!bytes.starts_with(png_signature)) throw broken();
    std::vector<PngChunk> chunks;
    for (std::size_t at = png_signature.size(); at + 12 <= bytes.size();) {
        const std::size_t length = big_endian(bytes.substr(at));
        if (length > bytes.size() - at - 12) throw broken();
        const std::uint32_t written = big_endian(bytes.substr(at + 8 + length));
        if (written != checksum(bytes.substr(at + 4, 4 + length))) throw broken();
        chunks.push_back({std::string(bytes.substr(at + 4, 4)), std::string(bytes.substr(at + 8, length))});
        at += length + 12;
        if (chunks.back().type == "IEND") return chunks;
    }
    throw broken();
}

} // namespace gaspard
