#include "globes.hpp"

#include "fixtures/fixture_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace gaspard {

namespace {

Vec3 unit(Vec3 p) { return (1 / norm(p)) * p; }

/// The integral of m sin from 0 to pi in so many trapezia, from the start to each end.
std::vector<double> integral_of(const std::function<double(double)>& m, std::size_t steps) {
    std::vector<double> sums{0};
    const double width = std::numbers::pi / static_cast<double>(steps);
    const auto f = [&](double t) { return m(t) * std::sin(t); };
    for (std::size_t i = 0; i < steps; ++i) {
        const double t = width * static_cast<double>(i);
        sums.push_back(sums.back() + width * (f(t) + f(t + width)) / 2);
    }
    return sums;
}

void adapt(Points& x, Vec3 pole, const std::function<double(double)>& m) {
    constexpr std::size_t steps = 20000;
    const std::vector<double> sums = integral_of(m, steps);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double along = std::clamp(dot(x[i], pole), -1.0, 1.0);
        const Vec3 aside = x[i] - along * pole;
        if (!(norm(aside) > 1e-12)) continue;
        const double wanted = (1 - along) / 2 * sums.back();
        const auto above = std::upper_bound(sums.begin() + 1, sums.end() - 1, wanted);
        const double part = (wanted - above[-1]) / (above[0] - above[-1]);
        const double t = std::numbers::pi / steps * (static_cast<double>(above - sums.begin()) - 1 + part);
        x.set(i, std::cos(t) * pole + std::sin(t) * unit(aside));
    }
}

double angle(Vec3 a, Vec3 b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

Snapshot snapshot_of(Mesh mesh, Points x, const std::function<double(Vec3)>& monitor) {
    Snapshot snapshot;
    Field field{{.name = "monitor"}, std::vector<double>(x.size())};
    for (std::size_t i = 0; i < x.size(); ++i) field.values[i] = monitor(x[i]);
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    snapshot.x = std::move(x);
    snapshot.fields.push_back(std::move(field));
    snapshot.report.iteration = 52;
    snapshot.report.residual = 9.8e-9;
    snapshot.report.status = RunStatus::converged;
    snapshot.version = 1;
    return snapshot;
}

double xn_monitor(double distance, double ratio) {
    const double gamma = std::pow(ratio, -4), alpha = std::numbers::pi / 20, beta = std::numbers::pi / 6;
    return std::sqrt((1 - gamma) / 2 * (std::tanh((beta - distance) / alpha) + 1) + gamma);
}

const Vec3 thirty_north{std::sqrt(3.0) / 2, 0, 0.5};

double band(double distance) {
    const double half_pi = std::numbers::pi / 2;
    const double sech = 1 / std::cosh(5 * (distance * distance - half_pi * half_pi));
    return 10 * sech * sech;
}

} // namespace

Mesh cubed_globe(int k, int order) {
    Mesh mesh = cubed_sphere_mesh(k);
    return order == 2 ? mesh : without_middles(mesh);
}

Mesh icosahedral_globe(int refinements, int order) {
    const double golden = std::numbers::phi;
    std::vector<Vec3> nodes;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-golden, golden})
            for (const Vec3 corner : {Vec3{0, a, b}, Vec3{a, b, 0}, Vec3{b, 0, a}})
                nodes.push_back(unit(corner));
    std::vector<std::array<std::int32_t, 3>> cells;
    const auto at = [&](std::int32_t i) { return nodes[static_cast<std::size_t>(i)]; };
    for (std::int32_t a = 0; a < 12; ++a)
        for (std::int32_t b = 0; b < 12; ++b)
            for (std::int32_t c = 0; c < 12; ++c) {
                const bool near =
                    dot(at(a), at(b)) > 0.4 && dot(at(b), at(c)) > 0.4 && dot(at(c), at(a)) > 0.4;
                const bool first = a < b && a < c && a != b && b != c;
                if (near && first && dot(at(a), cross(at(b), at(c))) > 0) cells.push_back({a, b, c});
            }
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
        const auto [entry, fresh] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(nodes.size()));
        if (fresh) nodes.push_back(unit(at(a) + at(b)));
        return entry->second;
    };
    for (int r = 0; r < refinements; ++r) {
        std::vector<std::array<std::int32_t, 3>> finer;
        for (const auto& [a, b, c] : cells) {
            const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        cells = std::move(finer);
    }
    Mesh mesh{.kind = {CellShape::triangle, order}, .space_dimension = 3, .nodes = {}, .cells = {}};
    for (const auto& [a, b, c] : cells) {
        mesh.cells.insert(mesh.cells.end(), {a, b, c});
        if (order == 2) mesh.cells.insert(mesh.cells.end(), {middle(a, b), middle(b, c), middle(c, a)});
    }
    mesh.nodes = Points(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) mesh.nodes.set(i, nodes[i]);
    return mesh;
}

Snapshot adapted_globe(Mesh mesh, Vec3 pole, const std::function<double(double)>& m) {
    Points x = mesh.nodes;
    adapt(x, pole, m);
    return snapshot_of(std::move(mesh), std::move(x), [&](Vec3 p) { return m(angle(p, pole)); });
}

Snapshot xn_globe(Mesh mesh, double ratio) {
    return adapted_globe(std::move(mesh), thirty_north, [ratio](double t) { return xn_monitor(t, ratio); });
}

Snapshot banded_globe(Mesh mesh) {
    const Vec3 first = thirty_north, second{-thirty_north.x, 0, thirty_north.z};
    Points x = mesh.nodes;
    adapt(x, first, [](double t) { return 1 + band(t); });
    adapt(x, second, [](double t) { return 1 + band(t); });
    return snapshot_of(std::move(mesh), std::move(x),
                       [&](Vec3 p) { return 1 + band(angle(p, first)) + band(angle(p, second)); });
}

Snapshot beside_exact_globe(int k) {
    Snapshot snapshot = xn_globe(cubed_globe(k, 2), 2);
    const Points exact = snapshot.x;
    for (std::size_t i = 0; i < exact.size(); ++i)
        snapshot.x.set(i, unit(exact[i] + 0.05 * (1 + exact.z[i]) * cross({0, 0, 1}, exact[i])));
    snapshot.exact = std::make_shared<const Points>(exact);
    return snapshot;
}

Snapshot tangled_globe(int k) {
    Snapshot snapshot = xn_globe(cubed_globe(k, 1), 16);
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
        const double away = angle(snapshot.x[i], thirty_north);
        if (away > 0.75 || away < 0.35) continue;
        // Too far inward, by an amount that differs from node to node.
        const double kick = 1.4 * std::sin(40 * snapshot.mesh->nodes.y[i]) * (0.75 - away);
        snapshot.x.set(i, unit(snapshot.x[i] + kick * thirty_north));
    }
    snapshot.report.status = RunStatus::tangled;
    return snapshot;
}

} // namespace gaspard
