// A coefficient of a PDE, or a width of a layer, as a formula in the coordinates and the problem's
// parameters, such as "(1 + 2*y)^2" or "1 - x".
#pragma once

#include "core/base/parameter.hpp"
#include "core/base/points.hpp"

#include <functional>
#include <map>
#include <span>
#include <string>

namespace gaspard {

/// A function of the position: values at x.size() points.
using Coefficient = std::function<void(const Points& x, std::span<double> values)>;

/// The formula of row `key`, on an interval or in the plane (`dimension` 1 or 2), with these names besides
/// the coordinates. Throws InputError, with the key, if it is not a formula in them; the coefficient throws
/// InputError, with the key and the point, where it is not finite.
Coefficient coefficient(const Values& values, const std::string& key, int dimension,
                        const std::map<std::string, double>& names);

/// The same, which throws InputError also where it is negative.
Coefficient coefficient_from_zero(const Values& values, const std::string& key, int dimension,
                                  const std::map<std::string, double>& names);

/// Row for a formula of a coefficient.
ParameterRow coefficient_row(const char* key, const char* label, const char* symbol, const char* formula,
                             const char* help);

} // namespace gaspard
