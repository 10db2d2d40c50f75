// The chunks that a PNG file consists of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

inline constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);

struct PngChunk {
    std::string type; ///< "IDAT"
    std::string content;
};

void append_big_endian(std::string& bytes, std::uint32_t value);
/// With its length before it and its checksum behind.
std::string png_chunk(std::string_view type, std::string_view content);
/// All of a file with these bytes. Throws MachineError, naming `file`, if it is no complete PNG, or if a
/// chunk does not have its checksum.
std::vector<PngChunk> png_chunks(std::string_view bytes, const std::filesystem::path& file);

} // namespace gaspard
