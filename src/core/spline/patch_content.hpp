// What a domain of a patch or a solid from a file has read: rows "file" and "patch" of its values.
#pragma once

#include "core/mesh/domain_type.hpp"
#include "core/spline/patch_file.hpp"

#include <exception>
#include <filesystem>
#include <optional>

namespace gaspard {

/// The patch of domain.file and domain.patch, or why there is none.
struct PatchContent {
    std::optional<FoundPatch> found{};
    std::exception_ptr error{};
};

/// DomainType::read. `directions`: 2 for patches, 3 for solids.
DomainContent read_patch_content(const Values& values, const std::filesystem::path& folder,
                                 std::size_t directions);
/// The patch of the content, which is read if it is null; throws the error of reading it.
FoundPatch patch_of_content(const Values& values, const std::filesystem::path& folder,
                            const DomainContent& content, std::size_t directions);

/// The row of domain.patch.
ParameterRow patch_row();

} // namespace gaspard
