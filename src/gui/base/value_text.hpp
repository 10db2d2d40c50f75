// How the window writes the values of parameters for people: "5×10⁻⁹", "30°", "0.79 rad". Files, TOML, CSV
// and the command line have format_number() and format_value() (core/base/parameter.hpp), which read back
// exactly.
#pragma once

#include "core/base/parameter.hpp"

#include <string>

namespace gaspard {

/// "5×10⁻⁹", in six significant digits; an integer in full.
std::string number_text(const ParameterRow& row, double number);
/// What follows a number: "°", " rad", " rad⁻²", " cells"; empty for a length, whose unit is that of the
/// domain and has no name.
std::string unit_text(const ParameterRow& row);
/// With the unit, "auto", "on" or "off", or the text itself.
std::string value_text(const ParameterRow& row, const Value& value);
/// What a row allows: "1 to 2000 rad⁻²", "−90° to 90°", "periodic, walls".
std::string range_text(const ParameterRow& row);

} // namespace gaspard
