// The methods that differ in nothing but their stepper.
#include "core/method/nested.hpp"

namespace gaspard {

MethodType accelerated_method() {
    return nested_method("accelerated", "Accelerated",
                         "Anderson acceleration of the relaxation, from coarser meshes on: no step to choose",
                         make_anderson_stepper);
}

MethodType newton_method() {
    return nested_method("newton", "Newton",
                         "the full linearisation, over powers of the monitor and from coarser meshes on: "
                         "quadratic convergence, also where the others fail",
                         make_newton_stepper);
}

MethodType automatic_method() {
    return nested_method(
        "auto", "Automatic",
        "chooses between accelerated and newton by what the iterations show, from coarser meshes on",
        make_automatic_stepper);
}

} // namespace gaspard
