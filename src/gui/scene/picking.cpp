#include "gui/scene/picking.hpp"

#include "core/base/error.hpp"
#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr std::uint32_t no_point = 0xffffffff;
constexpr double node_share =
    0.3; // of a cell's shortest edge; within this distance a node is picked, not the cell

/// A shown point in pixels, and its depth; larger is nearer to the viewer.
struct Seen {
    double x, y, near;
};

class Eye {
  public:
    Eye(const MeshScene& scene, const Camera& camera, Size size)
        : scene_(scene), camera_(camera), size_(size), forward_(towards_viewer(camera)) {}
    Seen operator()(std::uint32_t point) const {
        const Vec3 p = shown_point(scene_, point);
        const Pixel pixel = to_pixel(camera_, size_, p);
        return {pixel.x, pixel.y, dot(forward_, p - camera_.centre) / camera_.scale};
    }

  private:
    const MeshScene& scene_;
    Camera camera_;
    Size size_;
    Vec3 forward_;
};

std::uint32_t point_of_node(const Tessellation& t, std::uint32_t node) {
    if (t.starts.empty() && !t.base) return node < t.point_count ? node : no_point;
    for (std::uint32_t p = 0; p < t.point_count; ++p)
        if (t.node_of(p) == node) return p;
    return no_point;
}

struct CellHit {
    std::uint32_t cell = 0;
    double near = -std::numeric_limits<double>::infinity();
    bool found = false;
};

/// The front-most triangle that contains the pointer; in a tangled planar mesh the one that is drawn last.
CellHit cell_under(const MeshScene& scene, const std::vector<Seen>& seen, Pixel at) {
    const Tessellation& t = *scene.tessellation;
    CellHit hit;
    for (std::size_t i = 0; i < t.triangle_cells.size(); ++i) {
        const Seen &a = seen[t.triangles[3 * i]], &b = seen[t.triangles[3 * i + 1]],
                   &c = seen[t.triangles[3 * i + 2]];
        // Rejects triangles of zero area, too, which by rounding would contain any point.
        if (at.x < std::min({a.x, b.x, c.x}) || at.x > std::max({a.x, b.x, c.x}) ||
            at.y < std::min({a.y, b.y, c.y}) || at.y > std::max({a.y, b.y, c.y}))
            continue;
        const double u = (b.x - at.x) * (c.y - at.y) - (b.y - at.y) * (c.x - at.x);
        const double v = (c.x - at.x) * (a.y - at.y) - (c.y - at.y) * (a.x - at.x);
        const double w = (a.x - at.x) * (b.y - at.y) - (a.y - at.y) * (b.x - at.x);
        const double sum = u + v + w;
        const double slack =
            1e-9 * std::abs(sum); // a point on an edge belongs to a triangle in spite of rounding
        const bool inside = sum > 0 ? std::min({u, v, w}) >= -slack : std::max({u, v, w}) <= slack;
        if (!inside || !(std::abs(sum) > 0)) continue;
        const double near = (u * a.near + v * b.near + w * c.near) / sum;
        if (near >= hit.near) hit = {t.triangle_cells[i], near, true};
    }
    return hit;
}

/// Of cells that are lines: the nearest one.
CellHit line_under(const MeshScene& scene, const std::vector<Seen>& seen, Pixel at, double reach) {
    const Tessellation& t = *scene.tessellation;
    CellHit hit;
    double nearest = reach;
    for (std::size_t i = 0; i < t.segment_cells.size(); ++i) {
        const Seen &a = seen[t.segments[2 * i]], &b = seen[t.segments[2 * i + 1]];
        const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
        const double s =
            length > 0 ? std::clamp(((at.x - a.x) * x + (at.y - a.y) * y) / length, 0.0, 1.0) : 0;
        const double away = std::hypot(a.x + s * x - at.x, a.y + s * y - at.y);
        if (!(away < nearest)) continue;
        nearest = away;
        hit = {t.segment_cells[i], a.near + s * (b.near - a.near), true};
    }
    return hit;
}

/// Nodes among the corners of a cell's triangles (or its ends), and its shortest edge in pixels.
struct Corners {
    std::vector<std::uint32_t> points;
    double shortest = std::numeric_limits<double>::infinity();
};

Corners corners_of(const MeshScene& scene, const std::vector<Seen>& seen, std::uint32_t cell) {
    const Tessellation& t = *scene.tessellation;
    Corners corners;
    const auto collect = [&](std::span<const std::uint32_t> points, std::span<const std::uint32_t> cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i] != cell) continue;
            const std::size_t each = points.size() / cells.size();
            for (std::size_t k = 0; k < each; ++k)
                if (t.node_of(points[each * i + k])) corners.points.push_back(points[each * i + k]);
        }
    };
    collect(t.triangles, t.triangle_cells);
    collect(t.segments, t.segment_cells);
    std::sort(corners.points.begin(), corners.points.end());
    corners.points.erase(std::unique(corners.points.begin(), corners.points.end()), corners.points.end());
    for (std::size_t i = 0; i < corners.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Seen &a = seen[corners.points[i]], &b = seen[corners.points[j]];
            corners.shortest = std::min(corners.shortest, std::hypot(a.x - b.x, a.y - b.y));
        }
    return corners;
}

std::optional<std::uint32_t> nearest_point(std::span<const std::uint32_t> points,
                                           const std::vector<Seen>& seen, Pixel at, double reach) {
    std::optional<std::uint32_t> found;
    for (const std::uint32_t p : points) {
        const double away = std::hypot(seen[p].x - at.x, seen[p].y - at.y);
        if (away <= reach) reach = away, found = p;
    }
    return found;
}

/// Coordinates as text; those that are zero up to rounding, relative to the size of the mesh, are written as
/// 0.
std::string position(Vec3 p, int dimension, double size) {
    const auto coordinate = [size](double c) { return short_number(std::abs(c) < 1e-13 * size ? 0 : c, 6); };
    std::string text = coordinate(p.x);
    if (dimension > 1) text += ", " + coordinate(p.y);
    if (dimension > 2) text += ", " + coordinate(p.z);
    return text;
}

/// The number of cells along a side if the mesh is that of the unit square, where numbers give column and
/// row.
std::optional<std::uint32_t> square_side(const Mesh& mesh) {
    if (mesh.kind != CellKind{CellShape::quadrilateral, 1} || mesh.space_dimension != 2) return std::nullopt;
    const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(mesh.cell_count()))));
    const std::size_t row = n + std::size_t{1};
    if (std::size_t{n} * n != mesh.cell_count() || row * row != mesh.node_count()) return std::nullopt;
    const auto first = mesh.cell(0), last = mesh.cell(mesh.cell_count() - 1);
    const auto is = [](std::int32_t a, std::size_t b) { return static_cast<std::size_t>(a) == b; };
    if (!is(first[0], 0) || !is(first[3], row) || !is(last[2], row * row - 1)) return std::nullopt;
    return n;
}

std::string title_of(const Pick& pick, const Mesh& mesh) {
    std::string text = format_pick(pick);
    if (const auto n = square_side(mesh)) {
        const std::uint32_t row = pick.kind == Pick::Kind::cell ? *n : *n + 1;
        text += "  (" + std::to_string(pick.index % row) + ", " + std::to_string(pick.index / row) + ")";
    }
    return text;
}

/// The cells around a node, or the cell itself.
std::vector<std::size_t> cells_of(const Pick& pick, const Mesh& mesh) {
    if (pick.kind == Pick::Kind::cell) return {pick.index};
    const auto each = static_cast<std::size_t>(nodes_per_cell(mesh.kind));
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
        if (static_cast<std::uint32_t>(mesh.cells[i]) == pick.index) found.push_back(i / each);
    return found;
}

/// One value, or the smallest and the largest.
std::string range_text(const std::vector<double>& values, const std::vector<std::size_t>& cells) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::size_t cell : cells)
        low = std::min(low, values[cell]), high = std::max(high, values[cell]);
    const std::string first = short_number(low, 5), second = short_number(high, 5);
    return first == second ? first : first + " to " + second;
}

/// The mean over the corners of a cell, or the value of a node.
Vec3 place_of(const Pick& pick, const Mesh& mesh, const Points& points) {
    if (pick.kind == Pick::Kind::node) return points[pick.index];
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    Vec3 sum;
    for (std::size_t k = 0; k < corners; ++k)
        sum = sum + points[static_cast<std::size_t>(mesh.cell(pick.index)[k])];
    return (1.0 / static_cast<double>(corners)) * sum;
}

double node_value(const Pick& pick, const Mesh& mesh, const std::vector<double>& values) {
    if (pick.kind == Pick::Kind::node) return values[pick.index];
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    double sum = 0;
    for (std::size_t k = 0; k < corners; ++k)
        sum += values[static_cast<std::size_t>(mesh.cell(pick.index)[k])];
    return sum / static_cast<double>(corners);
}

} // namespace

std::optional<PickHit> pick_at(const MeshScene& scene, const Camera& camera, Size size, Pixel pointer,
                               double reach) {
    const Tessellation& t = *scene.tessellation;
    const Eye eye(scene, camera, size);
    std::vector<Seen> seen(t.point_count);
    for (std::uint32_t p = 0; p < t.point_count; ++p) seen[p] = eye(p);
    const bool lines = scene.cell_dimension == 1;
    const CellHit hit = lines ? line_under(scene, seen, pointer, reach) : cell_under(scene, seen, pointer);
    const Vec3 in_plane = to_world(camera, size, pointer);
    const Vec3 where = hit.found ? in_plane + (hit.near * camera.scale) * towards_viewer(camera) : in_plane;

    std::optional<std::uint32_t> point;
    if (hit.found) {
        const Corners corners = corners_of(scene, seen, hit.cell);
        point = nearest_point(corners.points, seen, pointer, std::min(reach, node_share * corners.shortest));
    } else if (scene.planar()) { // slightly outside the boundary
        std::vector<std::uint32_t> nodes;
        for (const std::uint32_t p : t.segments)
            if (t.node_of(p)) nodes.push_back(p);
        point = nearest_point(nodes, seen, pointer, reach);
    }
    if (point) return PickHit{{Pick::Kind::node, *t.node_of(*point)}, shown_point(scene, *point)};
    if (hit.found) return PickHit{{Pick::Kind::cell, hit.cell}, where};
    return std::nullopt;
}

std::vector<std::pair<Pixel, Pixel>> outline_of(const MeshScene& scene, const Camera& camera, Size size,
                                                std::uint32_t cell) {
    const Tessellation& t = *scene.tessellation;
    std::vector<std::pair<Pixel, Pixel>> lines;
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
        lines.emplace_back(to_pixel(camera, size, shown_point(scene, from)),
                           to_pixel(camera, size, shown_point(scene, to)));
    };
    for (std::size_t i = 0; i < t.segment_cells.size(); ++i)
        if (t.segment_cells[i] == cell) add(t.segments[2 * i], t.segments[2 * i + 1]);
    for (const auto& loop : cell_outlines(t, std::span(&cell, 1)))
        for (std::size_t k = 0; k < loop.size(); ++k) add(loop[k], loop[(k + 1) % loop.size()]);
    return lines;
}

std::optional<Pixel> middle_of(const Pick& pick, const MeshScene& scene, const Camera& camera, Size size) {
    if (pick.kind == Pick::Kind::node) {
        const std::uint32_t point = point_of_node(*scene.tessellation, pick.index);
        if (point == no_point) return std::nullopt;
        return to_pixel(camera, size, shown_point(scene, point));
    }
    Pixel sum;
    const auto sides = outline_of(scene, camera, size, pick.index);
    for (const auto& [from, to] : sides) sum.x += (from.x + to.x) / 2, sum.y += (from.y + to.y) / 2;
    if (sides.empty()) return std::nullopt;
    return Pixel{sum.x / static_cast<double>(sides.size()), sum.y / static_cast<double>(sides.size())};
}

/// The middles of the largest triangles of a cell that face the viewer, in pixels.
static std::vector<Pixel> facing_middles(const MeshScene& scene, const std::vector<Seen>& seen, Vec3 viewer,
                                         std::uint32_t cell) {
    constexpr std::size_t most = 6;
    const Tessellation& t = *scene.tessellation;
    std::vector<std::pair<double, Pixel>> facing;
    for (std::size_t i = 0; i < t.triangle_cells.size(); ++i) {
        if (t.triangle_cells[i] != cell) continue;
        const std::uint32_t* corners = &t.triangles[3 * i];
        const Vec3 a = shown_point(scene, corners[0]), b = shown_point(scene, corners[1]),
                   c = shown_point(scene, corners[2]);
        const double area = dot(cross(b - a, c - a), viewer);
        if (!(area > 0)) continue;
        Pixel middle;
        for (std::size_t k = 0; k < 3; ++k)
            middle.x += seen[corners[k]].x / 3, middle.y += seen[corners[k]].y / 3;
        facing.emplace_back(area, middle);
    }
    std::sort(facing.begin(), facing.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    facing.resize(std::min(facing.size(), most));
    std::vector<Pixel> middles;
    for (const auto& one : facing) middles.push_back(one.second);
    return middles;
}

/// Whether no other cell is in front of it, as far as its largest triangles tell.
static bool is_seen_of_solid(const Pick& pick, const MeshScene& scene, const Camera& camera) {
    const Eye eye(scene, camera, {1000, 1000}); // of any size
    std::vector<Seen> seen(scene.tessellation->point_count);
    for (std::uint32_t p = 0; p < seen.size(); ++p) seen[p] = eye(p);
    if (pick.kind == Pick::Kind::node) {
        constexpr double rounding = 0.5; // pixels
        const std::uint32_t point = point_of_node(*scene.tessellation, pick.index);
        if (point == no_point) return false;
        const CellHit hit = cell_under(scene, seen, {seen[point].x, seen[point].y});
        return !hit.found || hit.near <= seen[point].near + rounding;
    }
    const auto middles = facing_middles(scene, seen, towards_viewer(camera), pick.index);
    return std::any_of(middles.begin(), middles.end(),
                       [&](Pixel middle) { return cell_under(scene, seen, middle).cell == pick.index; });
}

bool faces_viewer(const Pick& pick, const MeshScene& scene, const Camera& camera) {
    if (scene.cell_dimension == 3) return is_seen_of_solid(pick, scene, camera);
    if (scene.ball == 0) return true;
    const Tessellation& t = *scene.tessellation;
    const Vec3 viewer = towards_viewer(camera);
    const auto faces = [&](std::uint32_t point) { return dot(shown_point(scene, point), viewer) > 0; };
    if (pick.kind == Pick::Kind::node) {
        const std::uint32_t point = point_of_node(t, pick.index);
        return point != no_point && faces(point);
    }
    for (std::size_t i = 0; i < t.triangle_cells.size(); ++i)
        if (t.triangle_cells[i] == pick.index)
            for (std::size_t k = 0; k < 3; ++k)
                if (faces(t.triangles[3 * i + k])) return true;
    return false;
}

PickFacts facts_of(const Pick& pick, const Snapshot& snapshot, ColouringMaker& cells,
                   const Colouring* colouring) {
    const Mesh& mesh = *snapshot.mesh;
    const double size = bounding_box(mesh.nodes).size();
    const auto place = [&](const Points& nodes) {
        return position(place_of(pick, mesh, nodes), mesh.space_dimension, size);
    };
    PickFacts facts = {{"", title_of(pick, mesh)}};
    const auto around = cells_of(pick, mesh);
    const std::string coloured = colouring ? colouring->name : "";
    if (colouring) {
        const std::string name =
            colouring->label + (colouring->symbol.empty() ? "" : " " + colouring->symbol);
        facts.emplace_back(name, colouring->place == FieldPlace::node
                                     ? short_number(node_value(pick, mesh, colouring->values), 5)
                                     : range_text(colouring->values, around));
    }
    facts.emplace_back("ξ", place(mesh.nodes));
    facts.emplace_back("x", place(snapshot.x));
    const int dimension = cell_dimension(mesh.kind);
    const char* measure = dimension == 1 ? "length" : dimension == 2 ? "area" : "volume";
    if (const Field* monitor = snapshot.field("monitor"); monitor && coloured != "monitor")
        facts.emplace_back("monitor", short_number(node_value(pick, mesh, monitor->values), 5));
    if (coloured != "area") facts.emplace_back(measure, range_text(cells.measures(snapshot), around));
    if (!cells.masses().empty()) facts.emplace_back("Mᵢ", range_text(cells.masses(), around));
    if (coloured != "jacobian") facts.emplace_back("Jacobian", range_text(cells.jacobians(snapshot), around));
    for (const Field& field : snapshot.fields) { // fields of the method
        static constexpr std::array<std::string_view, 3> said = {"monitor", "mass", "jacobian"};
        if (std::find(said.begin(), said.end(), field.name) != said.end() || field.name == coloured) continue;
        const std::string value = field.place == FieldPlace::node
                                      ? short_number(node_value(pick, mesh, field.values), 5)
                                      : range_text(field.values, around);
        facts.emplace_back(field.label.empty() ? field.name : field.label,
                           field.unit.empty() ? value : value + " " + field.unit);
    }
    return facts;
}

} // namespace gaspard
