#include "gui/panels/slider_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gaspard {

namespace {

/// The scale of a slider: the value, its logarithm, or, if the range is not positive, asinh, which is like a
/// logarithm for large values and is defined at zero.
double along(const ParameterRow& row, SliderRange ends, double value) {
    if (row.scale == ParameterScale::linear) return value;
    return ends.minimum > 0 ? std::log(value) : std::asinh(value);
}

} // namespace

double number_of(const Values& values, const ParameterRow& row) {
    return row.kind == ParameterKind::integer ? static_cast<double>(values.integer(row.key))
                                              : values.real(row.key);
}

void set_number(Values& values, const ParameterRow& row, double number) {
    if (row.kind == ParameterKind::integer)
        values.set(row.key, static_cast<std::int64_t>(std::llround(number)));
    else
        values.set(row.key, number);
}

SliderRange slider_ends(const ParameterRow& row) {
    return row.slider.value_or(SliderRange{row.minimum, row.maximum});
}

SliderRange widened(SliderRange ends, double value) {
    return {std::min(ends.minimum, value), std::max(ends.maximum, value)};
}

double position_of(const ParameterRow& row, SliderRange ends, double value) {
    const double low = along(row, ends, ends.minimum), high = along(row, ends, ends.maximum);
    return high > low ? (along(row, ends, value) - low) / (high - low) : 0;
}

double value_at(const ParameterRow& row, SliderRange ends, double position) {
    const double low = along(row, ends, ends.minimum), high = along(row, ends, ends.maximum);
    const double place = low + position * (high - low);
    if (row.scale == ParameterScale::linear) return place;
    return ends.minimum > 0 ? std::exp(place) : std::sinh(place);
}

double rounded(const ParameterRow& row, SliderRange ends, double value) {
    if (row.kind == ParameterKind::integer) return std::round(value);
    const double size =
        row.scale == ParameterScale::logarithmic ? std::abs(value) * 10 : ends.maximum - ends.minimum;
    if (size == 0 || !std::isfinite(size)) return value;
    const double decimals = 3 - std::floor(std::log10(size));
    const double factor = std::pow(10.0, std::abs(decimals));
    return decimals >= 0 ? std::round(value * factor) / factor : std::round(value / factor) * factor;
}

} // namespace gaspard
