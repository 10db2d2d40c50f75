// Checks of our own promises, always on. They are not for input: that gets an InputError.
#pragma once

#include "core/base/error.hpp"

#include <source_location>
#include <string>

namespace gaspard {

[[noreturn]] inline void check_failed(const char* expression,
                                      std::source_location where = std::source_location::current()) {
    throw InternalError(std::string("internal fault: ") + expression + " does not hold (" +
                        where.file_name() + ":" + std::to_string(where.line()) + ")");
}

} // namespace gaspard

#define GASPARD_CHECK(expression) ((expression) ? void() : ::gaspard::check_failed(#expression))
