// The table of patches that a user can choose.
#pragma once

#include "core/mesh/domain_type.hpp"
#include "core/spline/tensor_domain.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace gaspard {

/// The domain whose patch comes from a file (domain.file).
inline constexpr std::string_view own_patch_domain = "spline-patch";

/// Square, disk, quarter annulus, part of a torus, Möbius strip, and a patch from a file.
std::vector<DomainType> spline_domains();
/// `folder` is the base of a relative path. The file is read if `content` (DomainType::read) is null. Throws
/// InputError if the patch is invalid.
std::shared_ptr<const SplineDomain> make_spline_domain(const std::string& type, const Values& values,
                                                       const std::filesystem::path& folder = {},
                                                       const DomainContent& content = {});

} // namespace gaspard
