// Method types of nested iteration, which differ only in their stepper.
#include "core/method/nested.hpp"

namespace gaspard {

MethodType accelerated_method() {
    return nested_method("accelerated", "Accelerated",
                         "relaxation with Anderson acceleration and nested iteration; needs no step size",
                         make_anderson_stepper);
}

MethodType newton_method() {
    return nested_method(
        "newton", "Newton",
        "Newton's method with the full linearisation, continuation in powers of the monitor and "
        "nested iteration; converges quadratically, also if other methods fail",
        make_newton_stepper);
}

MethodType automatic_method() {
    return nested_method(
        "auto", "Automatic",
        "chooses between accelerated and newton from the observed convergence; nested iteration",
        make_automatic_stepper);
}

} // namespace gaspard
