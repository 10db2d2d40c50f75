// Figures: the drawing of a mesh as the section `view` says, on a page of its size.
//
// The page has view.width / view.dpi by view.height / view.dpi inches. It is drawn for paper, dark on the
// background of view.background, with the meshes of view.layout beside each other; a drawing has no other
// side and no map.
#pragma once

#include "core/base/parameter.hpp"
#include "core/io/svg.hpp"
#include "core/session/snapshot.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// `view`: values of view_rows(). `subject` and `last_iteration` are for the caption, as in caption_parts().
/// Throws InputError if the camera cannot be read.
std::string svg_of_figure(const Snapshot& snapshot, const Values& view, const std::string& subject = {},
                          int last_iteration = 0);

/// The meshes that the view shows, and how, without the page.
std::vector<SvgPanel> panels_of(const Snapshot& snapshot, const Values& view);
MeshSvgOptions mesh_svg_options(const Values& view);

/// Millimetres of so many pixels of the view.
double millimetres(const Values& view, double pixels);

} // namespace gaspard
