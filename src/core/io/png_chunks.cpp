#include "core/io/png_chunks.hpp"

#include "core/base/error.hpp"

#include <zlib.h>

namespace gaspard {

void append_big_endian(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xffU);
}

std::string png_chunk(std::string_view type, std::string_view content) {
    std::string chunk;
    append_big_endian(chunk, static_cast<std::uint32_t>(content.size()));
    chunk += type;
    chunk += content;
    const auto* body = reinterpret_cast<const Bytef*>(chunk.data() + 4);
    append_big_endian(chunk, static_cast<std::uint32_t>(crc32(0, body, static_cast<uInt>(chunk.size() - 4))));
    return chunk;
}

std::vector<PngChunk> png_chunks(std::string_view bytes, const std::filesystem::path& file) {
    const auto broken = [&] {
        return MachineError("cannot read " + file.string() + ": not a complete PNG file");
    };
    if (!bytes.starts_with(png_signature)) throw broken();
    std::vector<PngChunk> chunks;
    for (std::size_t at = png_signature.size(); at + 12 <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
        if (length > bytes.size() - at - 12) throw broken();
        chunks.push_back({std::string(bytes.substr(at + 4, 4)), std::string(bytes.substr(at + 8, length))});
        at += length + 12;
        if (chunks.back().type == "IEND") return chunks;
    }
    throw broken();
}

} // namespace gaspard
