// section.csv and section.svg: the values along the line view.section of a mesh in the plane.
#pragma once

#include "core/base/parameter.hpp"
#include "core/session/snapshot.hpp"

#include <array>
#include <filesystem>
#include <string_view>

namespace gaspard {

inline constexpr std::array<std::string_view, 2> section_file_names = {"section.csv", "section.svg"};

/// Whether they are written: the view has a line and colours, and the mesh lies in the plane.
bool has_section_files(const Mesh& mesh, const Values& view);
/// Writes nothing if the snapshot does not have the values that the colours show.
void write_section_files(const std::filesystem::path& folder, const Snapshot& snapshot, const Values& view);

} // namespace gaspard
