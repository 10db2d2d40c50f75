// Numbers as people read them: "0.25", "1.5×10⁻⁵", "−10⁹". In the window, in figures and in messages; what is
// to be read back has format_number() (core/base/parameter.hpp).
#pragma once

#include <string>

namespace gaspard {

/// `digits` significant digits without trailing zeros.
std::string short_number(double value, int digits = 4);
/// As few digits as tell the number from all others.
std::string exact_number(double value);
/// "10⁻⁸"
std::string power_of_ten(int exponent);

} // namespace gaspard
