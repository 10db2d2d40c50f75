// A snapshot as what a drawing shows of it: faces or lines with a value each, and the way to the page.
#pragma once

#include "core/io/mesh_outline.hpp"
#include "core/io/svg.hpp"
#include "core/io/svg_contours.hpp"
#include "core/io/svg_path.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/colouring.hpp"

#include <optional>
#include <span>
#include <vector>

namespace gaspard {

/// A drawn side of triangles, from the smaller number to the larger one, and points far beside it.
struct SectionSide {
    std::int32_t from = 0, to = 0, first = 0, second = 0;
};

struct SvgScene {
    Facets faces;               ///< cells of a surface, border of a solid
    std::vector<Side> lines;    ///< the cells of a curve in the plane or in space, which has no faces
    Points x, xi;               ///< where the nodes of both stand; xi tells which edges go straight on
    std::vector<double> values; ///< of the colouring, per face or line; empty without one
    std::vector<bool> tangled;  ///< per face or line
    SvgContours contours{};     ///< of the colouring
    bool spatial = false;       ///< has depth, so that some of it may hide the rest
    bool closed = false;        ///< no border: what turns away is hidden
    bool elevated = false;      ///< a plane mesh with heights
    /// Of a solid that is looked into (core/io/svg_section.hpp): the number of last faces that are caps, and
    /// the sides of faces that are drawn.
    bool section = false;
    std::size_t caps = 0;
    std::vector<SectionSide> section_sides{};

    std::size_t size() const { return lines.empty() ? faces.size() : lines.size(); }
};

/// `elevation`: as view.elevation.
SvgScene svg_scene(const Snapshot& snapshot, const std::optional<Colouring>& colouring, double elevation = 0);

/// An orthographic view of a scene on a part of the page.
struct SvgView {
    Vec3 right{1, 0, 0}, up{0, 1, 0}; ///< world directions that point right and up on the page; orthonormal
    double scale = 1;                 ///< points of the page per world unit
    PagePoint corner{};               ///< upper left, of the part of the page
    double width = 0, height = 0;     ///< of that part
    PagePoint origin{};               ///< where the world's origin is seen
    bool cropped = false;             ///< some of the scene may lie outside that part

    PagePoint page(Vec3 p) const { return {origin.x + scale * dot(right, p), origin.y - scale * dot(up, p)}; }
    Vec3 towards_viewer() const { return cross(right, up); }
    /// Whether any of these nodes, or a curve through them, may lie on the part of the page.
    bool shows(const Points& x, std::span<const std::int32_t> nodes) const;
};

/// The view of the options' camera. Without one, or with its axes alone, the whole scene: it keeps its
/// proportions, is at most `width` wide and 1.5 `width` high, and touches at least one of these limits. Axes
/// alone do not turn a planar scene.
SvgView svg_view(const SvgScene& scene, const MeshSvgOptions& options, PagePoint corner, double width);

/// The faces that are seen, the farthest first.
std::vector<std::uint32_t> painters_order(const SvgScene& scene, const SvgView& view);

} // namespace gaspard
