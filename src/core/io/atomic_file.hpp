// Files appear whole or not at all: written to a temporary name in the same folder, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace gaspard {

/// Calls `write` with a binary stream in the C locale. Whatever goes wrong (an exception of `write`, a full
/// disk, a folder that vanished), the temporary file is removed and an older file of that name is left as it
/// was. Throws MachineError naming file and cause.
void write_atomically(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

/// Makes the folder if need be and tries to write in it, so that an unwritable one is found before solving.
/// Leaves no trace of the trial beyond the folder. Throws InputError naming the folder and the cause
/// (MachineError for a full or failing disk).
void check_writable(const std::filesystem::path& folder);

} // namespace gaspard
