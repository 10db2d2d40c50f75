// Checks of internal invariants, always on. Invalid input throws InputError instead.
#pragma once

#include "core/base/error.hpp"

#include <source_location>
#include <string>

namespace gaspard {

[[noreturn]] inline void check_failed(const char* expression,
                                      std::source_location where = std::source_location::current()) {
    throw InternalError(std::string("internal error: ") + expression + " does not hold (" +
                        where.file_name() + ":" + std::to_string(where.line()) + ")");
}

} // namespace gaspard

#define GASPARD_CHECK(expression) ((expression) ? void() : ::gaspard::check_failed(#expression))
