// Checks of the numbers that describe a curve.
#pragma once

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"
#include "core/transport/convex_curve.hpp"

#include <cmath>
#include <string>

namespace gaspard {

/// `what` begins the sentence: "the semi-axis a".
inline void check_length(double length, const std::string& what, double longest = longest_length) {
    if (!(length >= shortest_length && length <= longest))
        throw InputError(what + " must be between " + exact_number(shortest_length) + " and " +
                         exact_number(longest) + ", not " + exact_number(length));
}

/// The longest side of a box.
inline void check_size(double size, const std::string& what) {
    check_length(size, "the size of the " + what, 2 * longest_length);
}

inline void check_finite(double number, const std::string& what) {
    if (!std::isfinite(number)) throw InputError(what + " must be a finite number");
}

} // namespace gaspard
