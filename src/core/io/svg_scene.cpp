#include "core/io/svg_scene.hpp"

#include "core/base/check.hpp"
#include "core/scenario/view_directions.hpp"
#include "core/tessellate/camera.hpp"
#include "core/tessellate/elevation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

namespace gaspard {

namespace {

std::size_t node_index(std::int32_t node) { return static_cast<std::size_t>(node); }

/// The scene's faces or lines with the cell and the nodes of each.
template <class Use>
void for_each_part(const SvgScene& scene, const Mesh& mesh, const Use& use) {
    for (std::size_t i = 0; i < scene.size(); ++i) {
        if (scene.lines.empty())
            use(scene.faces.cells[i], scene.faces[i].first(static_cast<std::size_t>(scene.faces.corners)));
        else
            use(static_cast<std::uint32_t>(i), mesh.cell(i).first(2));
    }
}

void add_values(SvgScene& scene, const Mesh& mesh, const Colouring& field) {
    for_each_part(scene, mesh, [&](std::uint32_t cell, std::span<const std::int32_t> corners) {
        double value = 0;
        for (const auto node : corners)
            value += field.place == FieldPlace::cell ? field.values[cell] : field.values[node_index(node)];
        value /= static_cast<double>(corners.size());
        GASPARD_CHECK(std::isfinite(value));
        scene.values.push_back(value);
    });
}

void add_tangled(SvgScene& scene, const Mesh& mesh, const std::vector<std::uint32_t>& cells) {
    for_each_part(scene, mesh, [&](std::uint32_t cell, std::span<const std::int32_t>) {
        scene.tangled.push_back(std::binary_search(cells.begin(), cells.end(), cell));
    });
}

std::vector<Side> lines_of(const Mesh& mesh) {
    std::vector<Side> lines;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto nodes = mesh.cell(c);
        Side line{nodes[0], nodes[1], mesh.kind.order - 1};
        std::copy(nodes.begin() + 2, nodes.end(), line.through.begin());
        lines.push_back(line);
    }
    return lines;
}

Vec3 face_normal(const SvgScene& scene, std::size_t face) {
    const auto n = scene.faces[face];
    const auto p = [&](std::size_t i) { return scene.x[node_index(n[i])]; };
    return scene.faces.corners == 3 ? cross(p(1) - p(0), p(2) - p(0)) : cross(p(2) - p(0), p(3) - p(1));
}

Vec3 face_centre(const SvgScene& scene, std::size_t face) {
    const auto corners = scene.faces[face].first(static_cast<std::size_t>(scene.faces.corners));
    Vec3 sum;
    for (const auto node : corners) sum = sum + scene.x[node_index(node)];
    return 1.0 / static_cast<double>(corners.size()) * sum;
}

} // namespace

SvgScene svg_scene(const Snapshot& snapshot, const std::optional<Colouring>& colouring, double elevation) {
    const Mesh& mesh = *snapshot.mesh;
    GASPARD_CHECK(snapshot.x.size() == mesh.node_count());
    SvgScene scene;
    scene.x = snapshot.x;
    if (colouring) scene.x = raised(snapshot.x, elevations(mesh, *colouring, elevation));
    scene.xi = mesh.nodes;
    if (cell_dimension(mesh.kind) > 1)
        scene.faces = shown_faces(mesh);
    else
        scene.lines = lines_of(mesh);
    const auto [low, high] = std::minmax_element(scene.x.z.begin(), scene.x.z.end());
    scene.spatial = *low < *high;
    scene.elevated = scene.spatial && mesh.space_dimension == 2;
    scene.closed = cell_dimension(mesh.kind) == 3 || (scene.spatial && border(mesh).size() == 0);
    if (colouring) add_values(scene, mesh, *colouring);
    if (colouring) scene.contours = svg_contours(snapshot, *colouring, scene.x);
    add_tangled(scene, mesh, ColouringMaker().tangled(snapshot));
    return scene;
}

/// The part of the world that a camera with centre and height shows.
static SvgView view_of_camera(const Camera& camera, PagePoint corner, Size size) {
    SvgView view{.right = camera.right, .up = camera.up, .scale = 1 / camera.scale, .corner = corner};
    view.width = size.width, view.height = size.height;
    view.origin = {corner.x + size.width / 2 - view.scale * dot(view.right, camera.centre),
                   corner.y + size.height / 2 + view.scale * dot(view.up, camera.centre)};
    view.cropped = true;
    return view;
}

/// Three digits of a number that is not below `least`.
static std::string at_least(double least) {
    char text[32];
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, 1.005 * least, std::chars_format::general, 3);
    GASPARD_CHECK(error == std::errc());
    return {text, end};
}

void check_svg_camera(const Points& nodes, const std::string& camera, double aspect) {
    constexpr double largest_zoom = 1e4; // so that coordinates in points stay far below 1e7
    if (camera.empty() || shows_all(camera)) return;
    const Size size{1, aspect};
    const Camera seen = parse_camera(camera, size);
    const Box box = bounding_box(nodes);
    const double height = aspect * seen.scale;
    const double least = (norm(box.high - box.low) + norm(seen.centre - box.centre())) / largest_zoom;
    if (height < least)
        throw InputError("view.camera shows a height of " + format_number(height) +
                         ", which is too small for an SVG of this mesh; it must be at least " +
                         at_least(least));
}

SvgView svg_view(const SvgScene& scene, const MeshSvgOptions& options, PagePoint corner, double width) {
    const Size size{width, options.aspect * width};
    const std::string& text = scene.elevated ? options.elevation_camera : options.camera;
    std::optional<Camera> camera;
    if (!text.empty()) camera = parse_camera(text, size);
    if (camera) check_svg_camera(scene.x, text, options.aspect);
    if (camera && !shows_all(text)) return view_of_camera(*camera, corner, size);
    SvgView view{.corner = corner};
    if (scene.spatial) {
        const ViewDirection& home = view_direction("home");
        view.right = camera ? camera->right : home.right;
        view.up = camera ? camera->up : home.up;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double left = infinity, right = -infinity, bottom = infinity, top = -infinity;
    for (std::size_t i = 0; i < scene.x.size(); ++i) {
        const double a = dot(view.right, scene.x[i]), b = dot(view.up, scene.x[i]);
        GASPARD_CHECK(std::isfinite(a) && std::isfinite(b));
        left = std::min(left, a), right = std::max(right, a);
        bottom = std::min(bottom, b), top = std::max(top, b);
    }
    view.scale = std::min(width / (right - left), 1.5 * width / (top - bottom));
    if (!std::isfinite(view.scale)) view.scale = 1; // a single point
    view.width = view.scale * (right - left), view.height = view.scale * (top - bottom);
    view.origin = {corner.x + (width - view.width) / 2 - view.scale * left, corner.y + view.scale * top};
    return view;
}

bool SvgView::shows(const Points& x, std::span<const std::int32_t> nodes) const {
    if (!cropped) return true;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double left = infinity, right_end = -infinity, top = infinity, bottom = -infinity;
    for (const std::int32_t node : nodes) {
        const PagePoint p = page(x[node_index(node)]);
        left = std::min(left, p.x), right_end = std::max(right_end, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    // A curved side may leave the box of its nodes by less than half the size of the box; a line has a width.
    const double across = (right_end - left) / 2 + 2, down = (bottom - top) / 2 + 2;
    return right_end + across >= corner.x && left - across <= corner.x + width && bottom + down >= corner.y &&
           top - down <= corner.y + height;
}

std::vector<std::uint32_t> painters_order(const SvgScene& scene, const SvgView& view) {
    const Vec3 viewer = view.towards_viewer();
    double volume = 0; // of what the faces enclose, times six
    for (std::size_t f = 0; f < scene.faces.size(); ++f)
        volume += dot(face_centre(scene, f), face_normal(scene, f));
    const double outward = volume < 0 ? -1 : 1;
    std::vector<std::uint32_t> order;
    std::vector<double> nearness;
    for (std::size_t f = 0; f < scene.faces.size(); ++f) {
        nearness.push_back(dot(viewer, face_centre(scene, f)));
        const Vec3 normal = face_normal(scene, f);
        // A part of a curved face may be seen although its corners turn away.
        const double limit = scene.faces.kind.order > 1 ? -0.5 * norm(normal) : 0;
        // An inverted cell is visible where its neighbours are.
        if (!scene.closed || scene.tangled[f] || outward * dot(viewer, normal) > limit)
            order.push_back(static_cast<std::uint32_t>(f));
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return nearness[a] < nearness[b]; });
    return order;
}

} // namespace gaspard
