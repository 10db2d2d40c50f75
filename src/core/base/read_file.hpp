// A whole file as bytes.
#pragma once

#include <filesystem>
#include <string>

namespace gaspard {

/// Throws InputError naming the file and the cause (no such file, a folder, no permission).
std::string read_file(const std::filesystem::path& file);

} // namespace gaspard
