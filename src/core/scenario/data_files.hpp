// The files that a scenario refers to: values of rows with the role `file`. A scenario that is saved names
// them relative to its own folder, or carries their bytes.
#pragma once

#include "core/base/export.hpp"
#include "core/scenario/scenario.hpp"

#include <cstdint>
#include <filesystem>

namespace gaspard GASPARD_API {

/// Whether some value is the path of a file.
bool has_data_files(const Scenario& scenario);

/// FNV-1a of the content of its files. Throws InputError if one cannot be read.
std::uint64_t hash_of_data(const Scenario& scenario);

/// The scenario with absolute paths, so that it can be saved in any folder.
Scenario with_absolute_paths(Scenario scenario);
/// The scenario for a file in `folder` (absolute), which becomes the base of its paths: they are relative, so
/// that scenario and data can be moved together. A file that shares no folder with it keeps its absolute
/// path.
Scenario with_relative_paths(Scenario scenario, const std::filesystem::path& folder);

/// The most bytes of files that are packed into a scenario.
inline constexpr std::uintmax_t most_packed_data = std::uintmax_t{2} << 20;
/// The scenario with the content of its files instead of their paths, as data: URIs (RFC 2397); it needs no
/// other file. Throws InputError if a file cannot be read or they have more bytes than most_packed_data.
Scenario with_packed_data(Scenario scenario);

} // namespace GASPARD_API
