// Reading a whole file.
#pragma once

#include <filesystem>
#include <string>

namespace gaspard {

/// Returns the file's bytes. Throws InputError if the file cannot be read (missing, a folder, no permission).
std::string read_file(const std::filesystem::path& file);

} // namespace gaspard
