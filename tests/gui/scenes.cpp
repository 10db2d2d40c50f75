#include "scenes.hpp"

#include "core/scenario/view_rows.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "globes.hpp"
#include "gui/app/viewport_image.hpp"

#include <array>
#include <cmath>

namespace gaspard {

namespace {

Snapshot finished(Mesh mesh, Points x) {
    Snapshot snapshot;
    Field monitor{{.name = "monitor"}, std::vector<double>(x.size())};
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 p = x[i] - Vec3{0.3, 0, 0.4};
        monitor.values[i] = 1 + std::exp(-8 * dot(p, p));
    }
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    snapshot.x = std::move(x);
    snapshot.fields.push_back(std::move(monitor));
    snapshot.report.iteration = 52;
    snapshot.report.residual = 9.8e-9;
    snapshot.report.set("equidistribution", 0.03667985);
    snapshot.report.status = RunStatus::converged;
    snapshot.version = 1;
    return snapshot;
}

Image draw(const Snapshot& snapshot, OffscreenBackend backend, const char* colour = "monitor",
           double blend = 1) {
    return render_view(snapshot, view(colour, blend), 400, 300, "plane, ring",
                       {.light = false, .backend = backend});
}

/// With settings as on a command line.
Image draw_with(const Snapshot& snapshot, OffscreenBackend backend,
                const std::vector<std::pair<std::string, std::string>>& settings) {
    Values values("view", view_rows());
    for (const auto& [key, text] : settings) values.parse(key, text);
    return render_view(snapshot, values, 400, 300, "plane, ring", {.light = false, .backend = backend});
}

/// Measured, as a run does it: the mean of the monitor at the corners stands for its integral.
Snapshot measured(Snapshot snapshot) {
    const Mesh& mesh = *snapshot.mesh;
    const CellGeometry geometry(snapshot.mesh);
    const std::vector<double> area = geometry.measures(snapshot.x), before = geometry.measures(mesh.nodes);
    Field mass{{.name = "mass", .place = FieldPlace::cell}, std::vector<double>(mesh.cell_count(), 0.0)};
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
        for (std::size_t k = 0; k < corners; ++k)
            mass.values[i] += snapshot.fields[0].values[static_cast<std::size_t>(mesh.cell(i)[k])];
        mass.values[i] *= area[i] / (before[i] * static_cast<double>(corners));
    }
    snapshot.fields.push_back(std::move(mass));
    return snapshot;
}

Plot convergence() {
    Plot plot;
    plot.title = "Convergence";
    plot.x.label = "iteration";
    plot.y = {"residual", true};
    Curve slow{"relaxation", {}, {}, false}, fast{"newton", {}, {}, true};
    for (int i = 0; i <= 100; ++i) {
        slow.x.push_back(i);
        slow.y.push_back(std::pow(10, -0.07 * i) * (1 + 0.3 * std::sin(0.4 * i)));
    }
    for (int i = 0; i <= 12; ++i) {
        fast.x.push_back(i * 3);
        fast.y.push_back(i == 6 ? std::nan("") : std::pow(10, -0.06 * i * i));
    }
    plot.curves = {slow, fast};
    return plot;
}

} // namespace

Values view(const std::string& colour, double blend) {
    Values values("view", view_rows());
    values.set("color", colour);
    values.set("blend", blend);
    return values;
}

Snapshot ring_snapshot(int n) {
    const Mesh mesh = unit_square_mesh(n);
    Points x = mesh.nodes;
    std::vector<double> values(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 from_centre = x[i] - Vec3{0.5, 0.5, 0};
        const double r = norm(from_centre);
        const double weight = 0.7 * std::exp(-40 * (r - 0.25) * (r - 0.25));
        const double moved = r + weight * (0.25 - r);
        if (r > 0) x.set(i, Vec3{0.5, 0.5, 0} + (moved / r) * from_centre);
        const double sech = 1 / std::cosh(100 * (moved * moved - 0.0625));
        values[i] = 1 + 10 * sech * sech;
    }
    Snapshot snapshot = finished(mesh, std::move(x));
    snapshot.fields[0].values = std::move(values);
    return snapshot;
}

Snapshot tangled_snapshot(int n) {
    Snapshot snapshot = ring_snapshot(n);
    const auto row = static_cast<std::size_t>(n + 1), corner = static_cast<std::size_t>(n / 3);
    const std::size_t node = corner * row + corner;
    snapshot.x.x[node] += 1.6 / n;
    snapshot.x.y[node] += 1.3 / n;
    Field jacobian{{.name = "jacobian", .place = FieldPlace::cell},
                   std::vector<double>(snapshot.mesh->cell_count(), 1.0)};
    jacobian.values[corner * (row - 1) + corner] = -0.4;
    snapshot.fields.push_back(std::move(jacobian));
    snapshot.report.tangled_cells = 1;
    snapshot.report.status = RunStatus::tangled;
    return snapshot;
}

Snapshot sphere_snapshot(int n) {
    struct Side {
        Vec3 normal, right, up;
    };
    const std::array<Side, 6> sides = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                        {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                        {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                        {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                        {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
                                        {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}};
    const int row = 2 * n + 1; // nodes along a side: corners and middles
    Mesh mesh;
    mesh.kind = {CellShape::quadrilateral, 2};
    mesh.space_dimension = 3;
    mesh.nodes = Points(static_cast<std::size_t>(6 * row * row));
    int node = 0;
    for (const Side& side : sides) {
        const int first = node;
        for (int j = 0; j < row; ++j)
            for (int i = 0; i < row; ++i) {
                const double s = std::tan((static_cast<double>(i) / (row - 1) - 0.5) * 1.5707963267948966);
                const double t = std::tan((static_cast<double>(j) / (row - 1) - 0.5) * 1.5707963267948966);
                const Vec3 p = side.normal + s * side.right + t * side.up;
                mesh.nodes.set(static_cast<std::size_t>(node++), (1 / norm(p)) * p);
            }
        constexpr std::array<std::array<int, 2>, 9> offsets = {
            {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (const auto& at : offsets)
                    mesh.cells.push_back(first + (2 * j + at[1]) * row + 2 * i + at[0]);
    }
    Points x = mesh.nodes;
    return finished(std::move(mesh), std::move(x));
}

Snapshot cube_snapshot(int n) {
    const int row = n + 1;
    Mesh mesh;
    mesh.kind = {CellShape::hexahedron, 1};
    mesh.space_dimension = 3;
    mesh.lattice = {n, n, n};
    mesh.nodes = Points(static_cast<std::size_t>(row * row * row));
    const auto number = [row](int i, int j, int k) { return (k * row + j) * row + i; };
    for (int k = 0; k < row; ++k)
        for (int j = 0; j < row; ++j)
            for (int i = 0; i < row; ++i)
                mesh.nodes.set(static_cast<std::size_t>(number(i, j, k)),
                               (1.0 / n) * Vec3{1.0 * i, 1.0 * j, 1.0 * k});
    constexpr std::array<std::array<int, 2>, 4> square = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (const int up : {0, 1})
                    for (const auto& at : square) mesh.cells.push_back(number(i + at[0], j + at[1], k + up));
    Points x = mesh.nodes;
    for (std::size_t i = 0; i < x.size(); ++i) x.x[i] += 0.05 * std::sin(6 * x.z[i]);
    return finished(std::move(mesh), std::move(x));
}

Snapshot bent_snapshot(int n) {
    const int row = 2 * n + 1;
    Mesh mesh;
    mesh.kind = {CellShape::hexahedron, 2};
    mesh.space_dimension = 3;
    mesh.lattice = {n, n, n};
    mesh.nodes = Points(static_cast<std::size_t>(row * row * row));
    for (int i = 0; i < row * row * row; ++i) {
        const Vec3 at =
            (1.0 / (row - 1)) * Vec3{1.0 * (i % row), 1.0 * (i / row % row), 1.0 * (i / row / row)};
        const double angle = 1.6 * at.x + 0.5 * at.z, radius = 0.5 + at.y + 0.15 * std::sin(4 * at.z);
        mesh.nodes.set(static_cast<std::size_t>(i),
                       {radius * std::cos(angle), -radius * std::sin(angle), 0.8 * at.z});
    }
    for (int c = 0; c < n * n * n; ++c)
        for (const Vec3 local : reference_nodes(mesh.kind)) {
            const auto place = [&](int cell, double s) { return 2 * cell + static_cast<int>(2 * s); };
            mesh.cells.push_back((place(c / n / n, local.z) * row + place(c / n % n, local.y)) * row +
                                 place(c % n, local.x));
        }
    Points x = mesh.nodes;
    Snapshot snapshot = finished(std::move(mesh), std::move(x));
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
        const Vec3 p = snapshot.x[i];
        snapshot.fields[0].values[i] = 2 + std::sin(7 * std::hypot(p.x, p.y)) * std::cos(5 * p.z);
    }
    return snapshot;
}

Snapshot interval_snapshot(int n) {
    Mesh mesh;
    mesh.kind = {CellShape::line, 1};
    mesh.space_dimension = 1;
    mesh.nodes = Points(static_cast<std::size_t>(n + 1));
    for (int i = 0; i <= n; ++i) mesh.nodes.x[static_cast<std::size_t>(i)] = static_cast<double>(i) / n;
    for (int i = 0; i < n; ++i) mesh.cells.insert(mesh.cells.end(), {i, i + 1});
    Points x = mesh.nodes;
    for (double& value : x.x) value *= value;
    return finished(std::move(mesh), std::move(x));
}

Snapshot layer_snapshot(int n, double width) {
    Snapshot snapshot = interval_snapshot(n);
    const auto solution = [width](double d) { return 1 - std::exp(-d / width); };
    Field here{{.name = "solution", .label = "solution"}, {}}, uniform{{.name = "solution_uniform"}, {}};
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
        const double xi = snapshot.mesh->nodes.x[i], from_end = 2 * std::min(xi, 1 - xi); // 0 to 1
        const double reach = std::min(8 * width, 0.25);
        const double d = from_end < 0.5 ? 2 * from_end * reach : reach + (2 * from_end - 1) * (0.5 - reach);
        snapshot.x.x[i] = xi <= 0.5 ? d : 1 - d;
        here.values.push_back(solution(d));
        uniform.values.push_back(solution(from_end / 2) * (i % 2 == 0 ? 1.1 : 0.95));
    }
    snapshot.fields = {std::move(here), std::move(uniform)};
    return snapshot;
}

Snapshot corner_layer_snapshot(int n, double width) {
    Mesh mesh;
    mesh.kind = {CellShape::triangle, 1};
    mesh.space_dimension = 2;
    mesh.nodes = Points(static_cast<std::size_t>((n + 1) * (n + 1)));
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.nodes.set(static_cast<std::size_t>(j * (n + 1) + i), (1.0 / n) * Vec3{1.0 * i, 1.0 * j, 0});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            mesh.cells.insert(mesh.cells.end(), {a, b, c, a, c, d});
        }
    Snapshot snapshot = finished(mesh, mesh.nodes);
    const auto moved = [width](double t) {
        const double start = 1 - 6 * width; // of the layer
        return t < 0.5 ? 2 * t * start : start + (2 * t - 1) * (1 - start);
    };
    const auto layer = [width](double t) { return t * (1 - std::exp((t - 1) / width)); };
    Field solution{{.name = "solution", .label = "solution"}, {}};
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
        const Vec3 x{moved(mesh.nodes.x[i]), moved(mesh.nodes.y[i]), 0};
        snapshot.x.set(i, x);
        solution.values.push_back(layer(x.x) * layer(x.y));
    }
    snapshot.fields.push_back(std::move(solution));
    return snapshot;
}

static Image draw_corner_layer(OffscreenBackend backend,
                               const std::vector<std::pair<std::string, std::string>>& settings) {
    Values values("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    for (const auto& [key, text] : settings) values.parse(key, text);
    return render_view(corner_layer_snapshot(16, 0.03), values, 600, 450, "square, layers",
                       {.light = false, .backend = backend});
}

/// With the view of a method that solves a problem.
static Image draw_layer(const Snapshot& snapshot, OffscreenBackend backend,
                        const std::vector<std::pair<std::string, std::string>>& settings) {
    Values values("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    for (const auto& [key, text] : settings) values.parse(key, text);
    return render_view(snapshot, values, 600, 450, "interval, layer", {.light = false, .backend = backend});
}

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all = {
        {"ring-16", [](OffscreenBackend backend) { return draw(ring_snapshot(16), backend); }},
        {"ring-60", [](OffscreenBackend backend) { return draw(ring_snapshot(60), backend); }},
        {"ring-240", [](OffscreenBackend backend) { return draw(ring_snapshot(240), backend); }},
        {"ring-computational",
         [](OffscreenBackend backend) { return draw(ring_snapshot(16), backend, "monitor", 0); }},
        {"ring-plain", [](OffscreenBackend backend) { return draw(ring_snapshot(16), backend, "none"); }},
        {"tangled", [](OffscreenBackend backend) { return draw(tangled_snapshot(16), backend); }},
        {"sphere", [](OffscreenBackend backend) { return draw(sphere_snapshot(6), backend); }},
        {"cube", [](OffscreenBackend backend) { return draw(cube_snapshot(5), backend); }},
        {"cube-cut",
         [](OffscreenBackend backend) {
             return draw_with(cube_snapshot(8), backend, {{"cut", "x 0.35 and -y 0.55 and z 0.4"}});
         }},
        {"cube-cut-cells",
         [](OffscreenBackend backend) {
             return draw_with(cube_snapshot(8), backend,
                              {{"cut", "normal 1 -1 0.6 at 0.5 0.5 0.5"},
                               {"color", "area"},
                               {"theme", "light"},
                               {"pick", "cell 219"}});
         }},
        {"cube-exploded",
         [](OffscreenBackend backend) {
             return draw_with(cube_snapshot(5), backend,
                              {{"explode", "0.3"}, {"layers", "i 0 to 3; k 0 to 2"}});
         }},
        {"bent-cut",
         [](OffscreenBackend backend) {
             return draw_with(bent_snapshot(5), backend,
                              {{"cut", "z 0.45"}, {"layout", "side-by-side"}, {"theme", "light"}});
         }},
        {"bent-cut-whole",
         [](OffscreenBackend backend) {
             return draw_with(bent_snapshot(6), backend,
                              {{"cut", "normal 1 -0.4 0.8 at 0.5 -0.5 0.45"}, {"cut_cells", "whole"}});
         }},
        {"interval", [](OffscreenBackend backend) { return draw(interval_snapshot(20), backend, "none"); }},
        {"interval-colours",
         [](OffscreenBackend backend) {
             return draw_with(interval_snapshot(20), backend,
                              {{"color", "area"}, {"color_map", "plasma"}, {"log", "true"}});
         }},
        {"layers",
         [](OffscreenBackend backend) { return draw_layer(layer_snapshot(32, 0.01), backend, {}); }},
        {"layers-side-by-side",
         [](OffscreenBackend backend) {
             return draw_layer(layer_snapshot(16, 1e-4), backend,
                               {{"layout", "side-by-side"}, {"theme", "light"}});
         }},
        {"layers-right-end",
         [](OffscreenBackend backend) {
             return draw_layer(layer_snapshot(32, 1e-8), backend, {{"x_axis", "log-right"}});
         }},
        {"contours",
         [](OffscreenBackend backend) {
             return draw_corner_layer(backend, {{"contours", "10"}});
         }},
        {"contours-both-domains",
         [](OffscreenBackend backend) {
             return draw_corner_layer(
                 backend,
                 {{"contours", "20"}, {"layout", "side-by-side"}, {"theme", "light"}, {"lines", "false"}});
         }},
        {"contours-globe",
         [](OffscreenBackend backend) {
             return draw_with(xn_globe(cubed_globe(8, 2), 2), backend,
                              {{"contours", "8"}, {"lines", "false"}, {"theme", "light"}});
         }},
        {"elevation",
         [](OffscreenBackend backend) {
             return draw_corner_layer(backend, {{"elevation", "1"}, {"contours", "10"}});
         }},
        {"elevation-both-domains",
         [](OffscreenBackend backend) {
             return draw_corner_layer(backend,
                                      {{"elevation", "1.2"}, {"layout", "side-by-side"}, {"theme", "light"}});
         }},
        {"area-ember-light",
         [](OffscreenBackend backend) {
             return draw_with(
                 ring_snapshot(16), backend,
                 {{"color", "area"}, {"color_map", "ember"}, {"theme", "light"}, {"histogram", "false"}});
         }},
        {"jacobian-yellow-log",
         [](OffscreenBackend backend) {
             return draw_with(
                 ring_snapshot(16), backend,
                 {{"color", "jacobian"}, {"color_map", "blue-yellow"}, {"log", "true"}, {"lines", "false"}});
         }},
        {"equidistribution",
         [](OffscreenBackend backend) {
             return draw_with(measured(ring_snapshot(16)), backend, {{"color", "equidistribution"}});
         }},
        {"displacement-grey-fixed",
         [](OffscreenBackend backend) {
             return draw_with(ring_snapshot(16), backend,
                              {{"color", "displacement"},
                               {"color_map", "grey"},
                               {"range", "fixed"},
                               {"low", "0.01"},
                               {"high", "0.04"},
                               {"arrows", "true"}});
         }},
        {"side-by-side",
         [](OffscreenBackend backend) {
             return draw_with(measured(ring_snapshot(16)), backend,
                              {{"layout", "side-by-side"},
                               {"theme", "light"},
                               {"pick", "cell 74"},
                               {"camera", "centre 0.4 0.45 height 0.9"}});
         }},
        {"tangled-240",
         [](OffscreenBackend backend) {
             return draw_with(tangled_snapshot(240), backend, {{"color_map", "plasma"}});
         }},
        {"sphere-top",
         [](OffscreenBackend backend) {
             return draw_with(
                 sphere_snapshot(6), backend,
                 {{"color", "area"}, {"direction", "top"}, {"pick", "cell 150"}, {"theme", "light"}});
         }},
        {"globe-x2", [](OffscreenBackend backend) { return draw(xn_globe(cubed_globe(8, 2), 2), backend); }},
        {"globe-x16-front-and-rear",
         [](OffscreenBackend backend) {
             return draw_with(xn_globe(cubed_globe(8, 2), 16), backend,
                              {{"layout", "front-and-rear"}, {"color", "none"}, {"theme", "light"}});
         }},
        {"globe-linear",
         [](OffscreenBackend backend) {
             return draw_with(xn_globe(cubed_globe(8, 1), 4), backend, {{"theme", "light"}});
         }},
        {"globe-dense",
         [](OffscreenBackend backend) { return draw(banded_globe(icosahedral_globe(5, 2)), backend); }},
        {"globe-map",
         [](OffscreenBackend backend) {
             return draw_with(
                 xn_globe(cubed_globe(8, 2), 4), backend,
                 {{"layout", "projection"}, {"projection_longitude", "160"}, {"pick", "cell 20"}});
         }},
        {"globe-exact",
         [](OffscreenBackend backend) {
             return draw_with(beside_exact_globe(6), backend, {{"overlay", "exact"}, {"direction", "right"}});
         }},
        {"globe-tangled",
         [](OffscreenBackend backend) {
             return draw_with(tangled_globe(10), backend, {{"theme", "light"}, {"color_map", "grey"}});
         }},
        {"plot",
         [](OffscreenBackend backend) {
             return render_plot(convergence(), 400, 300, {.light = true, .backend = backend});
         }},
        {"panels",
         [](OffscreenBackend backend) {
             const auto ring = std::make_shared<const Snapshot>(ring_snapshot(16));
             return render_panels(
                 {MeshPanel{"(a)", ring, "none", 0}, MeshPanel{"(b)", ring, "monitor", 1}, convergence()}, 3,
                 900, 300, {.light = true, .backend = backend});
         }},
    };
    return all;
}

} // namespace gaspard
