#include "gui/scene/mesh_scene.hpp"

#include "core/base/check.hpp"
#include "core/tessellate/elevation.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

Vec3 shown_point(const MeshScene& scene, std::uint32_t point) {
    const Vec3 from = (*scene.computational)[point], to = (*scene.physical)[point];
    const Vec3 straight = from + scene.blend * (to - from);
    if (scene.ball == 0 || scene.blend <= 0 || scene.blend >= 1) return straight;
    const double radius = norm(from) + scene.blend * (norm(to) - norm(from));
    return (radius / std::max(norm(straight), 1e-6 * scene.ball)) * straight;
}

std::shared_ptr<const MeshContours> make_contours(const MeshScene& scene) {
    if (scene.colouring == nullptr || scene.colouring->contours.values.empty()) return nullptr;
    const std::vector<double>& levels = scene.colouring->contours.values;
    const auto lines = contour_lines(*scene.tessellation, *scene.point_values, levels);
    if (lines.empty()) return nullptr;
    auto contours = std::make_shared<MeshContours>();
    contours->computational = contours->physical = Points(2 * lines.size());
    contours->values.reserve(2 * lines.size());
    for (const ContourSegment& segment : lines)
        for (const ContourPoint& point : {segment.from, segment.to}) {
            const std::size_t i = contours->values.size();
            contours->computational.set(i, point.in(*scene.computational));
            contours->physical.set(i, point.in(*scene.physical));
            contours->values.push_back(levels[segment.level]);
        }
    return contours;
}

void SceneBuilder::take_mesh(const Snapshot& snapshot, std::shared_ptr<const Tessellation> tessellation) {
    mesh_ = snapshot.mesh;
    last_ = {};
    workspaces_.clear();
    last_.tessellation = std::move(tessellation);
    computational_ = std::make_shared<const Points>(shown_points(*last_.tessellation, mesh_->nodes));
    last_.cell_dimension = cell_dimension(mesh_->kind);
    last_.mesh = mesh_;
    last_.ball = radius_of_ball(*mesh_);
    computational_box_ = bounding_box(*computational_);
}

std::shared_ptr<Points> SceneBuilder::available() {
    for (const auto& available : workspaces_)
        if (available.use_count() == 1) return available;
    return workspaces_.emplace_back(std::make_shared<Points>());
}

void SceneBuilder::take_positions(const Snapshot& snapshot) {
    target_box_ = snapshot.target ? bounding_box(*snapshot.target) : computational_box_;
    const std::shared_ptr<Points> shown = available();
    put_shown_points(*last_.tessellation, snapshot.x, *shown);
    physical_ = shown;
    last_version_ = snapshot.version;
}

/// From the flat meshes and the colours to what is shown.
void SceneBuilder::take_elevation(double factor) {
    elevation_ = factor;
    std::vector<double> nodes;
    if (last_.colouring != nullptr) nodes = elevations(*mesh_, *last_.colouring, factor);
    last_.elevation = nodes.empty() ? 0 : factor;
    last_.computational = computational_, last_.physical = physical_;
    Box computational = merge(computational_box_, target_box_), physical = bounding_box(*physical_);
    last_.burst = physical.size() > 1.5 * computational.size();
    if (!nodes.empty()) {
        const std::vector<double> z = shown_values(*last_.tessellation, nodes);
        last_.computational = std::make_shared<const Points>(raised(*computational_, z));
        last_.physical = std::make_shared<const Points>(raised(*physical_, z));
        computational = bounding_box(*last_.computational), physical = bounding_box(*last_.physical);
    }
    last_.box = merge(computational, physical);
    last_.home_box = last_.burst ? computational : last_.box;
}

void SceneBuilder::take_tangled(const Snapshot& snapshot) {
    std::vector<std::uint32_t> tangled = colouring_maker_.tangled(snapshot);
    if (tangled.empty())
        last_.tangled = nullptr;
    else if (last_.tangled == nullptr || *last_.tangled != tangled)
        last_.tangled = std::make_shared<const std::vector<std::uint32_t>>(std::move(tangled));
}

void SceneBuilder::take_colouring(const Snapshot& snapshot, const ColourChoice& choice) {
    choice_ = choice;
    last_.colouring = nullptr;
    last_.point_values = nullptr;
    auto made = colouring_maker_.make(snapshot, choice);
    if (!made) return;
    const auto colouring = std::make_shared<const Colouring>(std::move(*made));
    const Tessellation& tessellation = *last_.tessellation;
    last_.colouring = colouring;
    if (colouring->place == FieldPlace::cell)
        last_.point_values =
            std::make_shared<const std::vector<double>>(point_means(tessellation, colouring->values));
    else if (tessellation.starts.empty()) // shown points are nodes
        last_.point_values = {colouring, &colouring->values};
    else
        last_.point_values =
            std::make_shared<const std::vector<double>>(shown_values(tessellation, colouring->values));
}

void SceneBuilder::take_overlay(const Snapshot& snapshot, bool wanted) {
    if (!wanted || !snapshot.exact) {
        last_.overlay = nullptr;
        return;
    }
    if (last_.overlay && exact_ == snapshot.exact && last_.overlay->tessellation == last_.tessellation)
        return;
    exact_ = snapshot.exact;
    last_.overlay = std::make_shared<const MeshOverlay>(MeshOverlay{
        last_.tessellation, std::make_shared<const Points>(shown_points(*last_.tessellation, *exact_))});
}

MeshScene SceneBuilder::make(const Snapshot& snapshot, const Values& view) {
    GASPARD_CHECK(snapshot.mesh != nullptr);
    const bool new_mesh = mesh_ != snapshot.mesh;
    const bool new_positions = new_mesh || snapshot.version != last_version_;
    if (new_positions) {
        auto tessellation = cache_->get(snapshot);
        if (new_mesh || tessellation != last_.tessellation) take_mesh(snapshot, std::move(tessellation));
        take_positions(snapshot);
    }
    const ColourChoice choice = colour_choice(view);
    const bool new_colours = new_positions || !(choice == choice_);
    if (new_colours) take_colouring(snapshot, choice);
    if (const double factor = view.real("elevation"); new_colours || factor != elevation_) {
        take_elevation(factor);
        last_.contours = make_contours(last_);
    }
    if (new_positions) take_tangled(snapshot); // after the colours, which may have found the Jacobians
    take_overlay(snapshot, view.text("overlay") == "exact");
    last_.blend = view.real("blend");
    last_.lines = view.boolean("lines");
    return last_;
}

} // namespace gaspard
