// Figures for papers: vector graphics of a plot and of a mesh, as SVG 1.1 text.
//
// Sizes are in millimetres (one unit inside is a point) and text stays text, so that a drawing program can
// edit both. Invisible detail is left out: points closer than a quarter of a point are merged.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/background.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/inside_choice.hpp"
#include "core/tessellate/interval_plots.hpp"
#include "core/tessellate/plot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

struct PlotSvgOptions {
    double width_mm = 120, height_mm = 80;
};

/// Axes with ticks and grid, curves, and a legend where there are several. What a logarithmic axis cannot
/// show (zero, negative numbers) and what is not finite is a gap.
std::string svg_of_plot(const Plot& plot, const PlotSvgOptions& options = {});

struct SvgPage {
    double width_mm = 0, height_mm = 0; ///< 0: the usual size
    double text_size = 1;               ///< of texts and lines; 1: 8 points
};

/// The plots of an interval's mesh, columns beside each other.
std::string svg_of_plots(const std::vector<IntervalColumn>& columns, const Background& background = {},
                         const SvgPage& page = {});

struct MeshSvgOptions {
    double width_mm = 120;              ///< of the whole drawing
    double height_mm = 0;               ///< of the whole drawing; 0: as high as what it shows
    double text_size = 1;               ///< of texts and lines; 1: 8 points
    bool legend = true;                 ///< beside the mesh
    bool note = true;                   ///< below it, if cells are tangled
    std::vector<std::string> caption{}; ///< parts of the text below it
    int classes = 16;                   ///< colours
    std::string camera{};    ///< as view.camera; empty: the whole mesh, a mesh in space from slightly above
    double aspect = 0.75;    ///< height over width of what a camera with a centre and a height shows
    Background background{}; ///< the theme's is white
    bool lines = true;       ///< the edges of cells
    bool axes = false;       ///< of a flat mesh in the plane
    double elevation = 0;    ///< as view.elevation: above 0, a plane mesh is a surface in space
    std::string elevation_camera{}; ///< of that surface, instead of `camera`
    InsideChoice inside{};          ///< what is hidden of a solid
};

/// A mesh of a drawing that shows several states of it.
struct SvgPanel {
    std::string title{};                  ///< above it; empty where it is the only one
    double blend = 1;                     ///< as view.blend: nodes are at ξ + λ (x − ξ)
    std::optional<Colouring> colouring{}; ///< white without one
};

/// Throws InputError if `camera` cannot be read, or shows so small a part of points within `nodes` that their
/// places on the page have too many digits.
void check_svg_camera(const Points& nodes, const std::string& camera, double aspect);

/// The mesh at x: cells filled in classes of the colouring (white without one), edges as long lines (curved
/// ones as exact parabolas), magenta over tangled cells, a legend. Of a mesh in space hidden
/// faces are left out. Contour lines are those of the colouring, except on the border of a whole solid. A
/// solid that is looked into is drawn with straight pieces of curves.
/// A curve is drawn as a line; of an interval, see svg_of_plots(). The camera says from
/// where and which part; the height of the drawing follows from the mesh or, for a part, from `aspect`.
/// Throws InputError if the camera cannot be read.
std::string svg_of_mesh(const Snapshot& snapshot, const std::optional<Colouring>& colouring,
                        const MeshSvgOptions& options = {});
/// The same for several states of a mesh beside each other, on one scale, with the legend of the last. The
/// ids of the groups of all but the last begin with the title ("computational-cells").
std::string svg_of_meshes(const Snapshot& snapshot, const std::vector<SvgPanel>& panels,
                          const MeshSvgOptions& options = {});

void write_svg(const std::filesystem::path& file, const Plot& plot, const PlotSvgOptions& options = {});
void write_svg(const std::filesystem::path& file, const std::vector<IntervalColumn>& columns,
               const Background& background = {});
void write_svg(const std::filesystem::path& file, const Snapshot& snapshot,
               const std::vector<SvgPanel>& panels, const MeshSvgOptions& options = {});

} // namespace gaspard
