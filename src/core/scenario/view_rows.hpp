// The rows of the section "view": how a viewport shows a run.
#pragma once

#include "core/base/field.hpp"
#include "core/base/parameter.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace gaspard {

/// What cells can be coloured by on every mesh; tessellate/colouring.hpp makes the values.
const std::vector<FieldInfo>& mesh_colours();
/// The one of that name, which must be there.
const FieldInfo& mesh_colour(std::string_view name);

/// `further`: other fields to colour by (MethodType::fields, MonitorType::fields); `usual_colour`: one of
/// these or of mesh_colours(), the default of view.color (MethodType::colour).
std::vector<ParameterRow> view_rows(std::span<const FieldInfo> further = {},
                                    std::string_view usual_colour = "monitor");

} // namespace gaspard
