// Rows that patches and solids have in common, and what a domain from a file has read: rows "file" and
// "patch" of its values.
#pragma once

#include "core/mesh/domain_type.hpp"
#include "core/spline/patch_file.hpp"

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// The rows of domain.cells, from 4 to `most`, and domain.degree. `of`: "the patch has n × n cells".
std::vector<ParameterRow> cells_and_degree_rows(double most, std::int64_t usual, const std::string& of);
/// The row of domain.patch.
ParameterRow patch_row();

} // namespace gaspard
