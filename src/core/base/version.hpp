// Which Gaspard this is.
#pragma once

#include <string_view>

namespace gaspard {

std::string_view version(); ///< of the program, from CMakeLists.txt

} // namespace gaspard
