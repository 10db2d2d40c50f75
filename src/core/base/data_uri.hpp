// Bytes as text: data: URIs (RFC 2397).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gaspard {

/// "data:MEDIA-TYPE;base64,...", which read_data_file() reads.
std::string data_uri(std::string_view bytes, std::string_view media_type);
/// By the ending of the name: "image/png"; "application/octet-stream" where it says nothing.
std::string_view media_type_of(const std::filesystem::path& file);

} // namespace gaspard
