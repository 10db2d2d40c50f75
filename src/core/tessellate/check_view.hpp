// Whether the values of the section "view" can be shown.
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"

namespace gaspard GASPARD_API {

struct Mesh;

/// `view`: values of view_rows(). Throws InputError with one sentence if a camera, the background, the pick
/// or what is to be hidden cannot be read or a fixed range is empty; with a mesh also if the mesh does not
/// have the picked cell or node or the layers of cells, or cannot be shown in the layout.
void check_view(const Values& view, const Mesh* mesh = nullptr);

} // namespace GASPARD_API
