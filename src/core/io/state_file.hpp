// state.bin: the unknowns of a run with version and checksum, read by --start to continue the run.
//
// Little-endian layout: "GASPARD STATE\n\0\0" (16 bytes with padding); u32 version; u32 number of arrays;
// layout (u32 length, bytes); then for each array name (u32 length, bytes), u64 count, doubles; finally the
// 64-bit FNV-1a hash of all preceding bytes.
#pragma once

#include "core/base/export.hpp"
#include "core/method/method.hpp"

#include <filesystem>
#include <string_view>

namespace gaspard GASPARD_API {

/// Whether the first bytes of a file are those of a state.
bool is_state(std::string_view head);
/// Throws MachineError if the file cannot be written.
void write_state(const std::filesystem::path& file, const State& state);
/// Throws InputError if the file does not exist, is not a state file, is damaged or has another version.
State read_state(const std::filesystem::path& file);

} // namespace GASPARD_API
