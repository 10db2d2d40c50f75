#include "core/base/version.hpp"

namespace gaspard {

std::string_view version() { return GASPARD_VERSION; }

} // namespace gaspard
