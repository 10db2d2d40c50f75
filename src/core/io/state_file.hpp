// state.bin: the unknowns of a run, versioned and checked, which --start reads to go on.
//
// Little-endian: "GASPARD STATE\n\0\0" (16 bytes with padding), u32 version, u32 number of arrays, layout
// (u32 length, bytes), then per array: name (u32 length, bytes), u64 count, doubles; at the end a 64-bit
// FNV-1a of all before it.
#pragma once

#include "core/method/method.hpp"

#include <filesystem>

namespace gaspard {

/// Throws MachineError where the file cannot be written.
void write_state(const std::filesystem::path& file, const State& state);
/// Throws InputError: no such file, not a state, damaged, of a newer version.
State read_state(const std::filesystem::path& file);

} // namespace gaspard
