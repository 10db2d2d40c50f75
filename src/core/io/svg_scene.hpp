// A snapshot as what a drawing shows of it: faces or lines with a value each, and the way to the page.
#pragma once

#include "core/io/mesh_outline.hpp"
#include "core/io/svg.hpp"
#include "core/io/svg_path.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/colouring.hpp"

#include <optional>
#include <vector>

namespace gaspard {

struct SvgScene {
    Facets faces; ///< cells of a surface, border of a solid, or the band that an interval is drawn as
    std::vector<Side> lines;    ///< the cells of a curve in the plane or in space, which has no faces
    Points x, xi;               ///< where the nodes of both stand; xi tells which edges go straight on
    std::vector<double> values; ///< of the colouring, per face or line; empty without one
    std::vector<bool> tangled;  ///< per face or line
    bool spatial = false;       ///< has depth, so that some of it may hide the rest
    bool closed = false;        ///< no border: what turns away is hidden

    std::size_t size() const { return lines.empty() ? faces.size() : lines.size(); }
};

SvgScene svg_scene(const Snapshot& snapshot, const std::optional<Colouring>& colouring);

/// An orthographic look at a scene, fitted into a part of the page.
struct SvgView {
    SvgDirection direction;
    double scale = 1;             ///< points of the page per unit of the world
    PagePoint origin;             ///< where the world's origin is seen
    double width = 0, height = 0; ///< of the scene on the page

    PagePoint page(Vec3 p) const {
        return {origin.x + scale * dot(direction.right, p), origin.y - scale * dot(direction.up, p)};
    }
    Vec3 towards_viewer() const { return cross(direction.right, direction.up); }
};

/// `corner`: of the part of the page; the scene keeps its proportions and touches at least one limit.
/// In the plane `direction` says nothing.
SvgView svg_view(const SvgScene& scene, const std::optional<SvgDirection>& direction, PagePoint corner,
                 double width, double largest_height);

/// The faces that are seen, the farthest first.
std::vector<std::uint32_t> painters_order(const SvgScene& scene, const SvgView& view);

} // namespace gaspard
