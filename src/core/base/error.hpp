// The exception types. Numerical outcomes, such as a diverging iteration, are values and not exceptions.
#pragma once

#include "core/base/export.hpp"

#include <stdexcept>
#include <string>

namespace gaspard GASPARD_API {

/// Invalid user input; the text says what is wrong, where, and what is allowed. Exit code 2.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The machine lacks a resource (display, OpenGL, disk space). Exit code 1.
class MachineError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A violated internal invariant, found by GASPARD_CHECK. Exit code 1.
class InternalError : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// The user interrupted a long computation.
class Interrupted : public std::exception {
  public:
    const char* what() const noexcept override { return "interrupted"; }
};

} // namespace GASPARD_API
