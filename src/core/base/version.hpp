// The program's version.
#pragma once

#include "core/base/export.hpp"

#include <string_view>

namespace gaspard GASPARD_API {

std::string_view version(); ///< from CMakeLists.txt

} // namespace GASPARD_API
