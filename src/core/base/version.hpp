// The program's version.
#pragma once

#include <string_view>

namespace gaspard {

std::string_view version(); ///< from CMakeLists.txt

} // namespace gaspard
