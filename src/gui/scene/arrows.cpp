#include "gui/scene/arrows.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace gaspard {

namespace {

/// The best point of a square so far.
struct Candidate {
    float away = 0; ///< from the square's middle
    std::uint32_t point = 0;
};

/// Squares in the plane, in world units: a whole number of cells wide where cells are about squares of one
/// size, with a node in the middle, so that arrows form rows.
struct Squares {
    double side = 1;
    Vec3 origin;
};
Squares squares_of(const MeshScene& scene, double side) {
    const Vec3 extent = scene.box.high - scene.box.low;
    const auto& cells = scene.tessellation->triangle_cells;
    if (!scene.planar() || cells.empty()) return {side, scene.box.low};
    const double cell =
        std::sqrt(extent.x * extent.y / (*std::max_element(cells.begin(), cells.end()) + 1.0));
    if (!(cell > 0)) return {side, scene.box.low};
    const double many = std::max(1.0, std::round(side / cell));
    const double shift = std::fmod(many, 2) == 1 ? 0.5 * cell : 0;
    return {many * cell, scene.box.low - Vec3{shift, shift, 0}};
}

/// Nodes on lines that are drawn: of solids those at the surface.
std::vector<char> shown_nodes(const Tessellation& t) {
    std::vector<char> shown(t.point_count, 0);
    for (const std::uint32_t p : t.segments)
        if (t.node_of(p)) shown[p] = 1;
    return shown;
}

} // namespace

std::vector<std::uint32_t> points_with_arrows(const MeshScene& scene, const Camera& camera, Size size,
                                              double spacing) {
    const Points& xi = *scene.computational;
    const std::vector<char> shown = shown_nodes(*scene.tessellation);
    const Squares squares = squares_of(scene, spacing * camera.scale);
    const Vec3 axes[] = {camera.right, camera.up, towards_viewer(camera)};
    std::unordered_map<std::uint64_t, Candidate> best; ///< by square
    for (std::uint32_t p = 0; p < shown.size(); ++p) {
        if (shown[p] == 0) continue;
        const Pixel pixel = to_pixel(camera, size, xi[p]);
        const double margin = 4 * spacing; // an arrow may begin outside the view
        if (!(pixel.x > -margin && pixel.x < size.width + margin && pixel.y > -margin &&
              pixel.y < size.height + margin))
            continue;
        Candidate candidate{0, p};
        std::uint64_t square = 0;
        for (std::size_t k = 0; k < (scene.planar() ? 2U : 3U); ++k) {
            const double place = dot(axes[k], xi[p] - squares.origin) / squares.side, low = std::floor(place);
            square = square << 21 | (static_cast<std::uint64_t>(static_cast<std::int64_t>(low)) & 0x1fffff);
            // Rounded, so that rounding errors do not choose among points at the same distance.
            candidate.away += std::round(1024 * static_cast<float>(std::abs(place - low - 0.5)));
        }
        const auto [entry, fresh] = best.try_emplace(square, candidate);
        if (!fresh && candidate.away < entry->second.away) entry->second = candidate;
    }
    std::vector<std::uint32_t> points;
    for (const auto& [square, candidate] : best) points.push_back(candidate.point);
    std::sort(points.begin(), points.end());
    return points;
}

} // namespace gaspard
