#include "gui/scene/projection_scene.hpp"

#include "core/base/check.hpp"

#include <numbers>

namespace gaspard {

namespace {

std::shared_ptr<const Points> blended(const MeshScene& globe) {
    if (globe.blend >= 1) return globe.physical;
    if (globe.blend <= 0) return globe.computational;
    auto points = std::make_shared<Points>(globe.physical->size());
    for (std::uint32_t p = 0; p < points->size(); ++p) points->set(p, shown_point(globe, p));
    return points;
}

} // namespace

MeshScene ProjectionSceneBuilder::make(const MeshScene& globe, double longitude) {
    GASPARD_CHECK(globe.ball > 0);
    const MapProjection projection{globe.ball, longitude * std::numbers::pi / 180};
    const bool moved = globe.tessellation != globe_.tessellation || globe.physical != globe_.physical ||
                       globe.computational != globe_.computational || globe.blend != globe_.blend ||
                       projected_.projection != projection;
    const bool coloured_anew = moved || globe.colouring != globe_.colouring;
    if (moved) {
        made_ = map_sphere(globe.tessellation, *blended(globe), projection, &made_);
        projected_.tessellation = made_.tessellation;
        projected_.computational = projected_.physical = std::make_shared<const Points>(made_.points);
        projected_.projection = projection;
        const Vec3 half = globe.ball * std::numbers::sqrt2 * Vec3{2, 1, 0};
        projected_.box = projected_.home_box = {-1 * half, half};
    }
    if (coloured_anew)
        projected_.point_values =
            globe.point_values
                ? std::make_shared<const std::vector<double>>(map_values(made_, *globe.point_values))
                : nullptr;
    if (!globe.overlay)
        projected_.overlay = nullptr;
    else if (projected_.overlay == nullptr || globe.overlay != globe_.overlay || moved) {
        SphereMap lines = map_sphere(globe.overlay->tessellation, *globe.overlay->points, projection);
        projected_.overlay = std::make_shared<const MeshOverlay>(
            MeshOverlay{lines.tessellation, std::make_shared<const Points>(std::move(lines.points))});
    }
    projected_.colouring = globe.colouring;
    if (coloured_anew) projected_.contours = make_contours(projected_);
    projected_.mesh = globe.mesh;
    projected_.tangled = globe.tangled;
    projected_.lines = globe.lines;
    globe_ = globe;
    return projected_;
}

} // namespace gaspard
