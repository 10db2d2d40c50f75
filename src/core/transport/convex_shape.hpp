// Shapes of convex domains as the user sees them: rows, and curves made from their values.
#pragma once

#include "core/base/parameter.hpp"
#include "core/transport/convex_curve.hpp"

#include <memory>
#include <string>
#include <vector>

namespace gaspard {

/// The rows of a shape, with a prefix ("target."): first the one that chooses the shape, on which the others depend.
std::vector<ParameterRow> shape_choice_rows(const std::string& prefix, const std::string& whose);
/// The rows of the shape that is chosen. `values` has those of shape_choice_rows().
std::vector<ParameterRow> shape_rows(const Values& values, const std::string& prefix,
                                     const std::string& whose);

/// The curve of these values. Throws InputError that names the key.
std::shared_ptr<const ConvexCurve> make_shape(const Values& values, const std::string& prefix);

} // namespace gaspard
