#include "core/transport/lagrange_triangles.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace gaspard {

namespace {

constexpr int ends[3][2] = {{0, 1}, {1, 2}, {2, 0}};

/// Product of (k l - j) / (j + 1) for j = 0 .. n - 1, and its derivative by l.
std::pair<double, double> silvester(int k, int n, double l) {
    double value = 1, slope = 0;
    for (int j = 0; j < n; ++j) {
        const double factor = (k * l - j) / (j + 1);
        slope = slope * factor + value * k / (j + 1);
        value *= factor;
    }
    return {value, slope};
}

} // namespace

std::vector<std::array<int, 3>> lagrange_lattice(int degree) {
    std::vector<std::array<int, 3>> points = {{degree, 0, 0}, {0, degree, 0}, {0, 0, degree}};
    for (const auto& [a, b] : ends)
        for (int i = 1; i < degree; ++i) {
            std::array<int, 3> point{};
            point[static_cast<std::size_t>(a)] = degree - i;
            point[static_cast<std::size_t>(b)] = i;
            points.push_back(point);
        }
    if (degree == 3) points.push_back({1, 1, 1});
    return points;
}

TriangleShapes triangle_shapes(int degree, double s, double t) {
    const double l[3] = {1 - s - t, s, t};
    TriangleShapes shapes;
    for (const auto& node : lagrange_lattice(degree)) {
        double value[3], slope[3];
        for (std::size_t c = 0; c < 3; ++c) std::tie(value[c], slope[c]) = silvester(degree, node[c], l[c]);
        const double by[3] = {slope[0] * value[1] * value[2], value[0] * slope[1] * value[2],
                              value[0] * value[1] * slope[2]};
        shapes.values.push_back(value[0] * value[1] * value[2]);
        shapes.slopes.push_back({by[1] - by[0], by[2] - by[0]});
    }
    return shapes;
}

LagrangeTriangles::LagrangeTriangles(const Mesh& corners, const BoundarySides& boundary, int degree)
    : degree_(degree), per_cell_(lagrange_lattice(degree).size()), nodes_(corners.nodes) {
    GASPARD_CHECK(degree >= 1 && degree <= highest_triangle_degree);
    GASPARD_CHECK(corners.kind == (CellKind{CellShape::triangle, 1}));
    number(corners);
    std::map<std::pair<std::int32_t, std::int32_t>, Side> directed;
    for (std::size_t c = 0; c < corners.cell_count(); ++c)
        for (int e = 0; e < 3; ++e) {
            const auto& [a, b] = ends[e];
            const auto cell = corners.cell(c);
            directed[{cell[static_cast<std::size_t>(a)], cell[static_cast<std::size_t>(b)]}] = {c, e};
        }
    for (std::size_t i = 0; i < boundary.nodes.size(); ++i) {
        const auto side = directed.find({boundary.nodes[i], boundary.nodes[(i + 1) % boundary.nodes.size()]});
        GASPARD_CHECK(side != directed.end());
        sides_.push_back(side->second);
    }
    if (boundary.point && degree > 1) curve(boundary);
}

void LagrangeTriangles::number(const Mesh& corners) {
    const auto points = lagrange_lattice(degree_);
    const auto between = static_cast<std::size_t>(degree_ - 1);
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> edges; // the first node of an edge
    const auto add = [&](Vec3 x) {
        nodes_.x.push_back(x.x), nodes_.y.push_back(x.y), nodes_.z.push_back(x.z);
        return static_cast<std::int32_t>(nodes_.size()) - 1;
    };
    cells_.reserve(corners.cell_count() * per_cell_);
    for (std::size_t c = 0; c < corners.cell_count(); ++c) {
        const auto cell = corners.cell(c);
        const auto corner = [&](std::size_t i) { return corners.nodes[static_cast<std::size_t>(cell[i])]; };
        const auto at = [&](std::size_t node) {
            Vec3 x{};
            for (std::size_t i = 0; i < 3; ++i)
                x = x + (static_cast<double>(points[node][i]) / degree_) * corner(i);
            return x;
        };
        cells_.insert(cells_.end(), cell.begin(), cell.end());
        std::size_t node = 3;
        for (const auto& [a, b] : ends) {
            const auto from = cell[static_cast<std::size_t>(a)], to = cell[static_cast<std::size_t>(b)];
            const auto [edge, is_new] = edges.try_emplace({std::min(from, to), std::max(from, to)},
                                                          static_cast<std::int32_t>(nodes_.size()));
            for (std::size_t i = 0; i < between; ++i, ++node) {
                if (is_new)
                    cells_.push_back(add(at(node)));
                else // numbered from its other end on
                    cells_.push_back(edge->second + static_cast<std::int32_t>(between - 1 - i));
            }
        }
        if (degree_ == 3) cells_.push_back(add(at(node)));
    }
}

void LagrangeTriangles::curve(const BoundarySides& boundary) {
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        const auto [cell, edge] = sides_[i];
        const std::size_t first = cell * per_cell_ + 3 + static_cast<std::size_t>(edge * (degree_ - 1));
        for (int j = 1; j < degree_; ++j) {
            const auto node = static_cast<std::size_t>(cells_[first + static_cast<std::size_t>(j - 1)]);
            const Vec3 x = boundary.point(i, static_cast<double>(j) / degree_), before = nodes_[node];
            curved_ = curved_ || x != before;
            nodes_.set(node, x);
        }
        if (degree_ < 3) continue;
        // An edge displaced by d(r) moves points by l_a l_b q(r), q = d / (r (1 - r)); here q is linear.
        const auto centre = static_cast<std::size_t>(cells_[cell * per_cell_ + 9]);
        const auto corner = [&](int c) {
            return nodes_[static_cast<std::size_t>(cells_[cell * per_cell_ + static_cast<std::size_t>(c)])];
        };
        const Vec3 a = corner(ends[edge][0]), b = corner(ends[edge][1]);
        const Vec3 d = (nodes_[static_cast<std::size_t>(cells_[first])] - (2.0 / 3) * a - (1.0 / 3) * b) +
                       (nodes_[static_cast<std::size_t>(cells_[first + 1])] - (1.0 / 3) * a - (2.0 / 3) * b);
        nodes_.set(centre, nodes_[centre] + (1.0 / 4) * d);
    }
}

std::array<double, 2> LagrangeTriangles::on_edge(int edge, double r) {
    return edge == 0 ? std::array{r, 0.0} : edge == 1 ? std::array{1 - r, r} : std::array{0.0, 1 - r};
}

std::array<double, 2> LagrangeTriangles::Place::gradient(double ds, double dt) const {
    const double j = jacobian();
    return {(by_t[1] * ds - by_s[1] * dt) / j, (by_s[0] * dt - by_t[0] * ds) / j};
}

LagrangeTriangles::Place LagrangeTriangles::place(std::size_t cell, const TriangleShapes& shapes) const {
    Place place;
    const std::int32_t* numbers = cells_.data() + cell * per_cell_;
    for (std::size_t i = 0; i < per_cell_; ++i) {
        const auto n = static_cast<std::size_t>(numbers[i]);
        const double x = nodes_.x[n], y = nodes_.y[n];
        place.x.x += shapes.values[i] * x, place.x.y += shapes.values[i] * y;
        place.by_s[0] += shapes.slopes[i][0] * x, place.by_s[1] += shapes.slopes[i][0] * y;
        place.by_t[0] += shapes.slopes[i][1] * x, place.by_t[1] += shapes.slopes[i][1] * y;
    }
    return place;
}

} // namespace gaspard
