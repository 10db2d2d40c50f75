// The errors that cross a room's door. Numerical outcomes (a diverging iteration) are values, not errors.
#pragma once

#include <stdexcept>
#include <string>

namespace gaspard {

/// What the user gave is wrong; the text says what, where and what is allowed. The program ends with 2.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The machine cannot do it (no display, no OpenGL, disk full). The program ends with 1.
class MachineError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A fault of our own, found by GASPARD_CHECK. The program ends with 1.
class InternalError : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// The user asked to stop in the middle of long work.
class Interrupted : public std::exception {
  public:
    const char* what() const noexcept override { return "interrupted"; }
};

} // namespace gaspard
