// Shapes of convex domains as the user sees them: rows, and curves made from their values.
#pragma once

#include "core/base/parameter.hpp"
#include "core/transport/convex_curve.hpp"

#include <memory>
#include <string>
#include <vector>

namespace gaspard {

inline const std::string target_prefix = "target.";

/// The shape of a source whose mesh is from a file; it has no curve.
inline const std::string shape_of_file = "file";

/// The row that chooses a shape; its key has a prefix: none, or target_prefix. Only a source may be
/// shape_of_file.
ParameterRow shape_choice_row(const std::string& prefix, const std::string& whose);
/// The rows of the shape that is chosen. `values` has those of shape_choice_row().
std::vector<ParameterRow> shape_rows(const Values& values, const std::string& prefix,
                                     const std::string& whose);

/// Whether a domain's key belongs to the source, where it has a source and a target.
bool is_of_source(const Values& domain, const std::string& key);

/// The curve of these values, which are not shape_of_file. Throws InputError that names the key.
/// `origin`: the point that becomes (0, 0).
std::shared_ptr<const ConvexCurve> make_shape(const Values& values, const std::string& prefix,
                                              Vec3 origin = {});
/// A point in the middle of the shape, from its values alone; (0, 0) if they are not valid.
Vec3 middle_of_shape(const Values& values, const std::string& prefix);

} // namespace gaspard
