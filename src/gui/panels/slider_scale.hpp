// Where a value lies along its slider.
#pragma once

#include "core/base/parameter.hpp"

namespace gaspard {

/// The value of a row of kind real or integer.
double number_of(const Values& values, const ParameterRow& row);
/// Sets it; an integer is rounded.
void set_number(Values& values, const ParameterRow& row, double number);

/// The ends of a row's slider, as far as they are finite: those that the row says, else its range.
SliderRange slider_ends(const ParameterRow& row);
/// The same ends, moved so far that a value of the row is between them.
SliderRange widened(SliderRange ends, double value);

/// From 0 to 1: linear or logarithmic, as the row says.
double position_of(const ParameterRow& row, SliderRange ends, double value);
double value_at(const ParameterRow& row, SliderRange ends, double position);
/// A value of a slider, rounded to the precision of the mouse. Typed values are not rounded.
double rounded(const ParameterRow& row, SliderRange ends, double value);

} // namespace gaspard
