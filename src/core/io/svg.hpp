// Pictures for papers: vector graphics of a plot and of a mesh, as SVG 1.1 text.
//
// Measures are real ones (millimetres; inside, one unit is a point), text is text, so that both can be edited
// in a drawing program. What the eye cannot see is left out: points nearer than a quarter of a point merge.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/plot.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace gaspard {

/// The world's directions that point to the right of the page and up on it, of unit length, at right angles.
struct SvgDirection {
    Vec3 right{1, 0, 0}, up{0, 1, 0};
};

struct PlotSvgOptions {
    double width_mm = 120, height_mm = 80;
};

/// Axes with ticks and grid, curves, and a legend where there are several. What a logarithmic axis cannot
/// show (zero, negative numbers) and what is not finite is a gap.
std::string svg_of_plot(const Plot& plot, const PlotSvgOptions& options = {});

struct MeshSvgOptions {
    double width_mm = 120;              ///< of the whole picture; its height follows from the mesh
    int classes = 16;                   ///< colours
    std::optional<SvgDirection> from{}; ///< how a mesh in space is seen; empty: somewhat from above
};

/// The mesh at x: cells filled in classes of the colouring (white without one), edges as long lines (curved
/// ones as the parabolas that they are), tangled cells in magenta above all others, a legend. In the plane as
/// it is; in space seen from a fixed direction, somewhat from above, without what is hidden. An interval is a
/// band, a curve a line.
std::string svg_of_mesh(const Snapshot& snapshot, const std::optional<Colouring>& colouring,
                        const MeshSvgOptions& options = {});

void write_svg(const std::filesystem::path& file, const Plot& plot, const PlotSvgOptions& options = {});
void write_svg(const std::filesystem::path& file, const Snapshot& snapshot,
               const std::optional<Colouring>& colouring, const MeshSvgOptions& options = {});

} // namespace gaspard
