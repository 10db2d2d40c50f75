// What happens with a file that is opened in the window or dropped onto it: one table.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

enum class FileUse {
    scenario, ///< is opened
    image,    ///< becomes monitor.file of the monitor "image"
    field,    ///< becomes monitor.file of the monitor "field"
    patch,    ///< becomes domain.file of the domain "spline-patch"
    solid,    ///< becomes domain.file of the domain "spline-solid"
    mesh,     ///< becomes domain.file of the domain "convex", whose shape becomes "file"
    state,    ///< of an earlier run: the run starts from it
};

struct FileKind {
    FileUse use;
    std::string_view what;                 ///< "an image"
    std::vector<std::string_view> endings; ///< ".png"
};
std::span<const FileKind> file_kinds();

/// How much of a file use_of() looks at.
inline constexpr std::size_t head_size = std::size_t{1} << 20;
/// By the first bytes of the file for images, NetCDF and states, whatever their names, and else by the name;
/// whether a patch is a surface or a solid again by the first bytes. Nothing if it is none of the kinds.
std::optional<FileUse> use_of(const std::filesystem::path& file, std::string_view head);

/// "a scenario (.toml), an image (.png, .jpg, .jpeg), ... the mesh of a convex domain (.obj, .off,
/// .ply, .stl) or the state of an earlier run (.bin)"
std::string what_opens();
/// The endings of all kinds, or of one.
std::vector<std::string_view> endings_of(std::optional<FileUse> use = {});

/// The scenario with a file as its image, field or patch. Throws InputError if the scenario cannot have one.
Scenario with_file(const Catalogue& catalogue, const Scenario& opened, const Scenario& scenario, FileUse use,
                   const std::filesystem::path& file);

} // namespace gaspard
