#include "gui/arrows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace gaspard {

namespace {

struct Candidate {
    std::array<std::int32_t, 3> square; ///< across, up, towards the viewer
    float from_middle;                  ///< squared distance from the square's middle
    std::uint32_t point;
    friend bool operator<(const Candidate& a, const Candidate& b) {
        return std::tie(a.square, a.from_middle, a.point) < std::tie(b.square, b.from_middle, b.point);
    }
};

/// Whether a shown point is a node of the mesh, and not a point on a curved edge or face.
bool is_node(const Tessellation& t, std::uint32_t p) {
    return t.starts.empty() || t.starts[p + 1] - t.starts[p] == 1;
}

/// Nodes on lines that are drawn: of solids those at the surface.
std::vector<char> shown_nodes(const Tessellation& t) {
    std::vector<char> shown(t.point_count, 0);
    for (const std::uint32_t p : t.segments)
        if (is_node(t, p)) shown[p] = 1;
    return shown;
}

} // namespace

std::vector<std::uint32_t> points_with_arrows(const MeshPicture& picture, const Camera& camera, Size size,
                                              double spacing) {
    const Points& xi = *picture.computational;
    const std::vector<char> shown = shown_nodes(*picture.tessellation);
    const double side = spacing * camera.scale;
    const Vec3 axes[] = {camera.right, camera.up, towards_viewer(camera)};
    const Vec3 origin = picture.box.low; // squares begin there, wherever the camera is
    std::vector<Candidate> candidates;
    for (std::uint32_t p = 0; p < shown.size(); ++p) {
        if (shown[p] == 0) continue;
        const Pixel pixel = to_pixel(camera, size, xi[p]);
        const double margin = 4 * spacing; // an arrow may come in from beside the picture
        if (!(pixel.x > -margin && pixel.x < size.width + margin && pixel.y > -margin &&
              pixel.y < size.height + margin))
            continue;
        Candidate candidate{{0, 0, 0}, 0, p};
        for (std::size_t k = 0; k < (picture.planar() ? 2U : 3U); ++k) {
            const double place = dot(axes[k], xi[p] - origin) / side, square = std::floor(place);
            candidate.square[k] = static_cast<std::int32_t>(std::clamp(square, -1e9, 1e9));
            candidate.from_middle += static_cast<float>((place - square - 0.5) * (place - square - 0.5));
        }
        candidates.push_back(candidate);
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<std::uint32_t> points;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (i == 0 || candidates[i].square != candidates[i - 1].square) points.push_back(candidates[i].point);
    return points;
}

} // namespace gaspard
