#include "gui/scene/mesh_scene.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/tessellate/elevation.hpp"
#include "core/tessellate/visible_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
    const MeshScene before = std::exchange(last_, {});
    if (mesh_ == snapshot.mesh) last_.colouring = before.colouring, last_.tangled = before.tangled;
    mesh_ = snapshot.mesh;
    workspaces_.clear();
    last_.tessellation = std::move(tessellation);
    computational_ = std::make_shared<const Points>(shown_points(*last_.tessellation, mesh_->nodes));
    last_.cell_dimension = cell_dimension(mesh_->kind);
    last_.mesh = mesh_;
    last_.ball = radius_of_ball(*mesh_);
    computational_box_ = bounding_box(inside_.looks_inside() ? mesh_->nodes : *computational_);
}

/// Whether a section may be made while a frame waits for it.
static bool is_quick(const SectionJob& job, double last_seconds) {
    constexpr double longest = 0.005;   // seconds
    constexpr std::size_t many = 20000; // faces of cells that stand apart
    const auto pieces = static_cast<std::size_t>(job.pieces);
    const bool few = 6 * job.mesh->cell_count() * pieces * pieces <= many;
    return last_seconds < longest && (job.choice.explode == 0 || few);
}

/// What is left to see of a solid; planes cut it where it is shown. Null if it comes later.
std::shared_ptr<const Tessellation> SceneBuilder::section(const Snapshot& snapshot, const Values& view) {
    const Mesh& mesh = *snapshot.mesh;
    const double blend = view.real("blend");
    SectionJob job{.mesh = snapshot.mesh,
                   .faces = cache_->faces(snapshot),
                   .x = Points(mesh.node_count()),
                   .choice = inside_,
                   .pieces = cache_->get(snapshot)->cuts};
    for (std::size_t i = 0; i < job.x.size(); ++i)
        job.x.set(i, (1 - blend) * mesh.nodes[i] + blend * snapshot.x[i]);
    job.visible =
        visible_cells(mesh, *job.faces, inside_,
                      condition_values(colouring_maker_, snapshot, inside_, view.text("color")), job.x);
    job.number = ++section_number_;
    if (worker_ && !is_quick(job, section_seconds_)) {
        worker_->post(std::move(job));
        return nullptr;
    }
    if (worker_) worker_->withdraw();
    const MadeSection made = section_making_.make(job);
    section_seconds_ = made.seconds;
    shown_section_ = job.number;
    return made.tessellation;
}

/// What the other thread has made since the last call, if no other section was made or asked for in its place
/// without waiting; else null.
std::shared_ptr<const Tessellation> SceneBuilder::finished_section(const std::shared_ptr<const Mesh>& mesh) {
    const auto made = worker_ ? worker_->take() : std::nullopt;
    if (!made || made->mesh != mesh || made->number <= shown_section_) return nullptr;
    shown_section_ = made->number;
    section_seconds_ = made->seconds;
    return made->tessellation;
}

std::shared_ptr<Points> SceneBuilder::available() {
    for (const auto& available : workspaces_)
        if (available.use_count() == 1) {
            std::shared_ptr<Points> own = available; // counts, which orders its last use on another thread
            return own;                              // before what is written now
        }
    return workspaces_.emplace_back(std::make_shared<Points>());
}

void SceneBuilder::take_positions(const Snapshot& snapshot) {
    target_box_ = snapshot.target ? bounding_box(*snapshot.target) : computational_box_;
    const std::shared_ptr<Points> shown = available();
    put_shown_points(*last_.tessellation, snapshot.x, *shown);
    physical_ = shown;
    last_.nodes = inside_.looks_inside() ? std::make_shared<const Points>(snapshot.x) : nullptr;
    last_version_ = snapshot.version;
}

/// From the flat meshes and the colours to what is shown.
void SceneBuilder::take_elevation(double factor) {
    elevation_ = factor;
    std::vector<double> nodes;
    if (last_.colouring != nullptr) nodes = elevations(*mesh_, *last_.colouring, factor);
    last_.elevation = nodes.empty() ? 0 : factor;
    last_.computational = computational_, last_.physical = physical_;
    Box computational = merge(computational_box_, target_box_),
        physical = bounding_box(last_.nodes ? *last_.nodes : *physical_);
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
    if (auto made = colouring_maker_.make(snapshot, choice))
        last_.colouring = std::make_shared<const Colouring>(std::move(*made));
}

void SceneBuilder::take_point_values() {
    last_.point_values = nullptr;
    const auto colouring = last_.colouring;
    if (colouring == nullptr) return;
    const Tessellation& tessellation = *last_.tessellation;
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

/// What the view says of the inside of a solid; a text that cannot be read is as good as empty.
static InsideChoice inside_of(const Mesh& mesh, const Values& view) {
    if (cell_dimension(mesh.kind) != 3) return {};
    try {
        return inside_choice(view);
    } catch (const InputError&) {
        return {};
    }
}

MeshScene SceneBuilder::make(const Snapshot& snapshot, const Values& view) {
    GASPARD_CHECK(snapshot.mesh != nullptr);
    const bool new_mesh = mesh_ != snapshot.mesh;
    const bool new_positions = new_mesh || snapshot.version != last_version_;
    const ColourChoice choice = colour_choice(view);
    const InsideChoice before = std::exchange(inside_, inside_of(*snapshot.mesh, view));
    const bool inside = inside_.looks_inside();
    const bool by_values = !inside_.only.empty() && (new_positions || !(choice == choice_));
    const bool new_section =
        inside_ != before || (inside && (new_mesh || view.real("blend") != last_.blend || by_values ||
                                         (new_positions && !inside_.cut.empty())));
    std::shared_ptr<const Tessellation> shape;
    if (inside && new_section) shape = section(snapshot, view);
    if (!shape) shape = finished_section(snapshot.mesh);
    if (!inside) { // a section that was still being made is of no use
        shape = nullptr, shown_section_ = section_number_;
        if (worker_) worker_->withdraw();
    }
    const bool come = shape != nullptr;
    if (!shape && inside && !new_mesh) shape = last_.tessellation;
    if (!shape) shape = new_positions || new_section ? cache_->get(snapshot) : last_.tessellation;
    if (new_positions || new_section || come) {
        if (new_mesh || shape != last_.tessellation) take_mesh(snapshot, std::move(shape));
        take_positions(snapshot);
    }
    const bool new_colours = new_positions || !(choice == choice_);
    if (new_colours) take_colouring(snapshot, choice);
    const bool new_shape = new_section || come;
    if (new_colours || new_shape) take_point_values();
    if (const double factor = view.real("elevation"); new_colours || new_shape || factor != elevation_) {
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
