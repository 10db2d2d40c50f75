#include "core/layer/quadrilateral_domain.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/mesh/control_points.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace gaspard {

namespace {

constexpr const char* corners_key = "domain.corners";

Vec3 at(const Corners& c, double s, double t) {
    return (1 - s) * (1 - t) * c[0] + s * (1 - t) * c[1] + s * t * c[2] + (1 - s) * t * c[3];
}

Points uniform_grid(int n) {
    const auto side = static_cast<std::size_t>(n) + 1;
    Points grid(side * side);
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i)
            grid.set(j * side + i, {static_cast<double>(i) / n, static_cast<double>(j) / n, 0});
    return grid;
}

Corners parse_corners(const Values& values) {
    const Points points = parse_control_points(values.text("corners"), 4, corners_key, "a quadrilateral");
    return {points[0], points[1], points[2], points[3]};
}

/// Twice the area of the triangle of corner k and its neighbours.
double turn(const Corners& c, std::size_t k) { return cross(c[k] - c[(k + 3) % 4], c[(k + 1) % 4] - c[k]).z; }

void check_convex(const Corners& corners) {
    Points points(4);
    for (std::size_t k = 0; k < 4; ++k) points.set(k, corners[k]);
    const double side = longest_side(bounding_box(points)), least = 1e-8 * side * side;
    const auto turns = [&](double sign) {
        for (std::size_t k = 0; k < 4; ++k)
            if (!(sign * turn(corners, k) > least)) return false;
        return true;
    };
    if (turns(1)) return;
    throw InputError(std::string(corners_key) + (turns(-1)
                                                     ? " are clockwise; write them anticlockwise from the "
                                                       "lower left"
                                                     : " are not those of a convex quadrilateral, "
                                                       "anticlockwise from the lower left"));
}

} // namespace

QuadrilateralDomain::QuadrilateralDomain(const Corners& corners, int cells)
    : corners_(corners), cells_(cells) {
    auto points = std::make_shared<Points>(4);
    for (std::size_t k = 0; k < 4; ++k) points->set(k, corners[k]);
    corner_points_ = std::move(points);
    Mesh mesh{.kind = {CellShape::triangle, 1},
              .space_dimension = 2,
              .nodes = positions(uniform_grid(cells)),
              .cells = {}};
    mesh.cells.reserve(6 * static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (std::int32_t j = 0; j < cells; ++j)
        for (std::int32_t i = 0; i < cells; ++i) {
            const std::int32_t a = j * (cells + 1) + i, b = a + 1, d = a + cells + 1, c = d + 1;
            mesh.cells.insert(mesh.cells.end(), {a, b, c, a, c, d});
        }
    mesh_ = std::make_shared<const Mesh>(std::move(mesh));
}

std::size_t QuadrilateralDomain::unknowns() const {
    const auto n = static_cast<std::size_t>(cells_);
    return 2 * (n + 1) * (n - 1); // each coordinate is given on two sides
}

Points QuadrilateralDomain::positions(const Points& parameters) const {
    Points x(parameters.size());
    for (std::size_t i = 0; i < x.size(); ++i) x.set(i, at(corners_, parameters.x[i], parameters.y[i]));
    return x;
}

Points QuadrilateralDomain::parameters_at(const Points& positions) const {
    GASPARD_CHECK(has_vertical_sides());
    Points found(positions.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double s = (positions.x[i] - corners_[0].x) / (corners_[1].x - corners_[0].x);
        const double low = at(corners_, s, 0).y, high = at(corners_, s, 1).y;
        found.set(i, {s, (positions.y[i] - low) / (high - low), 0});
    }
    return found;
}

bool QuadrilateralDomain::has_vertical_sides() const {
    return corners_[0].x == corners_[3].x && corners_[1].x == corners_[2].x;
}

DomainType quadrilateral_domain() {
    return {
        .name = "quadrilateral",
        .label = "Quadrilateral",
        .help = "a convex quadrilateral, divided into 2 N² triangles; nodes slide along its sides",
        .rows = {{.key = "cells",
                  .label = "Cells per side",
                  .symbol = "N",
                  .kind = ParameterKind::integer,
                  .minimum = 2,
                  .maximum = 512,
                  .scale = ParameterScale::logarithmic,
                  .slider = SliderRange{4, 256},
                  .default_value = std::int64_t{32},
                  .help = "the mesh has 2 N x N triangles"},
                 {.key = "corners",
                  .label = "Corners",
                  .kind = ParameterKind::text,
                  .default_value = std::string("0 0, 1 0, 1 1, 0 1"),
                  .help = "anticlockwise from the lower left, as \"x y, x y, x y, x y\"; drag them in the "
                          "window",
                  .role = ParameterRole::control_points}},
        .space = [](const Values& values, const DomainContent&) {
            Space space{.dimension = 2};
            try {
                const Corners corners = parse_corners(values);
                space.corners.assign(corners.begin(), corners.end());
                Points points(4);
                for (std::size_t k = 0; k < 4; ++k) points.set(k, corners[k]);
                space.reach = {bounding_box(points)};
            } catch (const InputError&) { // which the run reports
            }
            return space;
        }};
}

std::shared_ptr<const QuadrilateralDomain> make_quadrilateral(const Values& values) {
    const Corners corners = parse_corners(values);
    check_convex(corners);
    return std::make_shared<QuadrilateralDomain>(corners, static_cast<int>(values.integer("cells")));
}

Points resampled_grid(const Points& from, int from_cells, int cells) {
    const auto side = static_cast<std::size_t>(cells) + 1, coarse = static_cast<std::size_t>(from_cells) + 1;
    Points to(side * side);
    const auto place = [&](std::size_t i) { // the cell and the place in it
        const std::size_t cell = std::min(i * (coarse - 1) / (side - 1), coarse - 2);
        return std::pair(cell, static_cast<double>(i * (coarse - 1) - cell * (side - 1)) /
                                   static_cast<double>(side - 1));
    };
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const auto [ci, s] = place(i);
            const auto [cj, t] = place(j);
            const std::size_t corner = cj * coarse + ci;
            to.set(j * side + i, (1 - s) * (1 - t) * from[corner] + s * (1 - t) * from[corner + 1] +
                                     (1 - s) * t * from[corner + coarse] + s * t * from[corner + coarse + 1]);
        }
    return to;
}

} // namespace gaspard
