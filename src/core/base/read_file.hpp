// Reading a whole file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>

namespace gaspard {

/// The largest file that is read unless the caller says otherwise: 256 MiB.
inline constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 28;

/// Returns the file's bytes; reads pipes to their end. Throws InputError if the file cannot be read (missing,
/// a folder, no permission) or has more than `limit` bytes, as endless devices such as /dev/zero do; also if
/// it is a named pipe that nothing opens for writing within 10 s. Throws Interrupted if `stop` is requested
/// while it waits for a pipe.
std::string read_file(const std::filesystem::path& file, std::uintmax_t limit = largest_file,
                      const std::stop_token& stop = {});

} // namespace gaspard
