// Data that a value of a row with the role `file` names: a file, or the bytes themselves as a data:
// URI (RFC 2397),
//
//     data:[<media type>][;base64],<data>
//
// The data of a URI are base64 or text with percent escapes. "gaspard:NAME" is a file of assets/pictures,
// assets/fields or assets/meshes, which is part of the program, for the built-in scenarios.
#pragma once

#include "core/base/read_file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace gaspard {

/// Whether the text begins with "data:" in any case, after blanks.
bool is_data_uri(std::string_view text);

/// Whether the text names a file that is part of the program.
bool is_shipped_data(std::string_view text);

/// How messages name it: the path, or "the packed data".
std::string data_file_name(std::string_view text, const std::filesystem::path& folder = {});

/// The bytes of the file, whose path is relative to `folder` (user_path), or of the data: URI. Throws
/// InputError if the file cannot be read, the URI is not valid, or there are more than `limit` bytes.
std::string read_data_file(std::string_view text, const std::filesystem::path& folder = {},
                           std::uintmax_t limit = largest_file);

} // namespace gaspard
