// The table of spline solids that a user can choose.
#pragma once

#include "core/mesh/domain_type.hpp"
#include "core/spline/tensor_domain.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// The domain whose solid comes from a file (domain.file).
inline constexpr std::string_view own_solid_domain = "spline-solid";

/// Cube, ball, cylinder, half torus, and a solid from a file.
std::vector<DomainType> solid_domains();
/// `folder` is the base of a relative path. The file is read if `content` (DomainType::read) is null. Throws
/// InputError if the solid is invalid.
std::shared_ptr<const SolidDomain> make_solid_domain(const std::string& type, const Values& values,
                                                     const std::filesystem::path& folder = {},
                                                     const DomainContent& content = {});

} // namespace gaspard
