#include "core/diagnostics/interpolation_cells.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

constexpr int gauss_points = 3; // per direction
constexpr int grid = 4;         // intervals of the grid per direction
constexpr double rounding = 1e-12;

/// Straight cells where they fill the space or are projected to the sphere; else those of the mesh.
CellKind geometry_of(const Mesh& mesh, const Space& space) {
    const bool straight =
        cell_dimension(mesh.kind) == mesh.space_dimension || space.kind == SpaceKind::sphere;
    return {mesh.kind.shape, straight ? 1 : mesh.kind.order};
}

struct Half {
    Vec3 offset;
    double sign = 1;
};

std::vector<Half> halves_of(CellShape shape) {
    if (shape == CellShape::line) return {{{0, 0, 0}}, {{.5, 0, 0}}};
    if (shape == CellShape::triangle) return {{{0, 0, 0}}, {{.5, 0, 0}}, {{0, .5, 0}}, {{.5, .5, 0}, -1}};
    std::vector<Half> halves{{{0, 0, 0}}, {{.5, 0, 0}}, {{0, .5, 0}}, {{.5, .5, 0}}};
    if (shape == CellShape::hexahedron)
        for (std::size_t i = 0; i < 4; ++i) halves.push_back({halves[i].offset + Vec3{0, 0, .5}});
    return halves;
}

std::size_t grid_index(int i, int j, int k) {
    return static_cast<std::size_t>((k * (grid + 1) + j) * (grid + 1) + i);
}

} // namespace

void ErrorSums::add(const ErrorSums& other) {
    square += other.square, slope += other.slope, measure += other.measure;
    maximum = std::max(maximum, other.maximum);
}

InterpolationCells::InterpolationCells(const Mesh& mesh, const Points& x, const Space& space,
                                       const ScalarFunction& u)
    : mesh_(mesh), x_(x), u_(u), straight_{mesh.kind.shape, 1}, kind_(geometry_of(mesh, space)),
      dimension_(cell_dimension(mesh.kind)), flat_(dimension_ == mesh.space_dimension),
      rule_(cell_quadrature(mesh.kind.shape, gauss_points)) {
    GASPARD_CHECK(x.size() == mesh.node_count());
    if (space.kind == SpaceKind::sphere) radius_ = norm(mesh.nodes[0]);
    const Vec3 third = Vec3{1.0 / 3, 1.0 / 3, 0};
    middle_ = shape_at(mesh.kind.shape == CellShape::triangle ? third : Vec3{.5, .5, .5});
    halve({}, halves_);
    for (std::size_t i = 0; i < halves_.size(); ++i) halves_[i].known = 1 + i;
    std::vector<CellPart> known{{}};
    known.insert(known.end(), halves_.begin(), halves_.end());
    for (const CellPart& part : known) {
        shapes_.emplace_back();
        for (const CellPoint& p : rule_)
            shapes_.back().push_back(shape_at(part.origin + part.size * p.point));
    }
    const int ny = dimension_ > 1 ? grid : 0, nz = dimension_ > 2 ? grid : 0;
    grid_of_.assign(grid_index(grid, grid, grid) + 1, -1);
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= grid; ++i) {
                if (mesh.kind.shape == CellShape::triangle && i + j > grid) continue;
                grid_of_[grid_index(i, j, k)] = static_cast<int>(grid_.size());
                grid_places_.push_back({i, j, k});
                grid_.push_back(shape_at((1.0 / grid) * Vec3{double(i), double(j), double(k)}));
            }
    for (const Vec3 corner : reference_nodes(straight_)) corner_.push_back(shape_at(corner));
}

void InterpolationCells::halve(const CellPart& part, std::vector<CellPart>& halves) const {
    std::size_t known = 0;
    for (const Half& half : halves_of(mesh_.kind.shape)) {
        ++known;
        halves.push_back({part.cell, part.halvings + 1, part.halvings == 0 ? known : 0,
                          part.origin + part.size * half.offset, half.sign * part.size / 2});
    }
}

void InterpolationCells::set_shape(Vec3 point, Shape& shape) const {
    const auto corners = static_cast<std::size_t>(nodes_per_cell(straight_));
    shape.corner_values.resize(corners), shape.corner_gradients.resize(corners);
    shape_functions(straight_, point, shape.corner_values, shape.corner_gradients);
    if (kind_ == straight_) return;
    const auto nodes = static_cast<std::size_t>(nodes_per_cell(kind_));
    shape.values.resize(nodes), shape.gradients.resize(nodes);
    shape_functions(kind_, point, shape.values, shape.gradients);
}

InterpolationCells::Shape InterpolationCells::shape_at(Vec3 point) const {
    Shape shape;
    set_shape(point, shape);
    return shape;
}

/// Without the sign of the Jacobian.
InterpolationCells::Place InterpolationCells::flat_or_curved(std::span<const Vec3> nodes,
                                                             const Shape& shape) const {
    const bool straight = kind_ == straight_;
    const std::span<const double> values = straight ? shape.corner_values : shape.values;
    Place place;
    place.tangents = cell_tangents(dimension_, straight ? shape.corner_gradients : shape.gradients,
                                   [&](std::size_t k) { return nodes[k]; });
    Vec3 from_first{};
    for (std::size_t k = 1; k < nodes.size(); ++k)
        from_first = from_first + values[k] * (nodes[k] - nodes[0]);
    place.x = nodes[0] + from_first;
    if (radius_ == 0) return place;
    const double length = norm(place.x), factor = radius_ / length;
    const Vec3 direction = (1 / length) * place.x;
    place.x = radius_ * direction;
    for (int d = 0; d < dimension_; ++d) {
        Vec3& t = place.tangents[static_cast<std::size_t>(d)];
        t = factor * (t - dot(t, direction) * direction);
    }
    return place;
}

/// Positive where the cell lies as it should.
double InterpolationCells::signed_jacobian(const Batch& batch, std::size_t cell, const Place& at) const {
    const Tangents& t = at.tangents;
    if (radius_ > 0 && dimension_ == 2) {
        const Vec3 normal = cross(t[0], t[1]);
        return std::copysign(norm(normal), dot(normal, at.x));
    }
    return batch.sign[cell] * signed_measure(dimension_, flat_ ? dimension_ : 3, t, batch.facing[cell]);
}

InterpolationCells::Place InterpolationCells::place(const Batch& batch, std::size_t cell,
                                                    const Shape& shape) const {
    const auto count = static_cast<std::size_t>(nodes_per_cell(kind_));
    Place at = flat_or_curved({batch.nodes.data() + cell * count, count}, shape);
    at.jacobian = signed_jacobian(batch, cell, at);
    return at;
}

void InterpolationCells::evaluate(const Points& points, std::vector<double>& values) const {
    values.resize(points.size());
    u_.values(points, values);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw InputError("the function whose interpolation error is measured is not finite at (" +
                             exact_number(points.x[i]) + ", " + exact_number(points.y[i]) + ", " +
                             exact_number(points.z[i]) + ")");
}

void InterpolationCells::begin(std::size_t from, std::size_t to, Batch& batch) const {
    batch.begin = from, batch.end = to;
    const std::size_t cells = to - from;
    const auto count = static_cast<std::size_t>(nodes_per_cell(kind_));
    const auto corners = static_cast<std::size_t>(nodes_per_cell(straight_));
    batch.nodes.resize(cells * count);
    batch.facing.resize(cells), batch.sign.assign(cells, 1), batch.tangled.assign(cells, 0);
    batch.points.resize(cells * corners);
    std::vector<Vec3> reference(count);
    for (std::size_t c = 0; c < cells; ++c) {
        const auto cell = mesh_.cell(from + c);
        for (std::size_t n = 0; n < count; ++n) {
            batch.nodes[c * count + n] = x_[static_cast<std::size_t>(cell[n])];
            reference[n] = mesh_.nodes[static_cast<std::size_t>(cell[n])];
        }
        for (std::size_t n = 0; n < corners; ++n)
            batch.points.set(c * corners + n, x_[static_cast<std::size_t>(cell[n])]);
        batch.facing[c] = flat_or_curved({batch.nodes.data() + c * count, count}, middle_).tangents;
        if (!flat_) continue;
        const Tangents uniform = flat_or_curved(reference, middle_).tangents;
        batch.facing[c] = uniform;
        if (dimension_ > 1)
            batch.sign[c] = std::copysign(1, signed_measure(dimension_, dimension_, uniform, {}));
    }
    evaluate(batch.points, batch.corners);
}

void InterpolationCells::note(Batch& batch, std::size_t slot, std::size_t cell, const Shape& shape,
                              const Place& at, double weight) const {
    const std::size_t corners = shape.corner_values.size();
    const double* u = batch.corners.data() + cell * corners;
    double rise = 0; // Iu - u at the first corner, which keeps digits
    Vec3 slope{};
    for (std::size_t k = 1; k < corners; ++k) {
        rise += shape.corner_values[k] * (u[k] - u[0]);
        slope = slope + (u[k] - u[0]) * shape.corner_gradients[k];
    }
    batch.points.set(slot, at.x);
    batch.interpolated[slot] = u[0] + rise;
    batch.slopes[slot] = slope;
    batch.tangents[slot] = at.tangents;
    batch.weight[slot] = weight;
}

namespace {

/// |grad e|^2 for the derivatives of e along the tangents.
double slope_square(int dimension, const Tangents& t, Vec3 along) {
    if (dimension == 1) return along.x * along.x / dot(t[0], t[0]);
    const Vec3 normal = cross(t[0], t[1]);
    const Vec3 third = dimension == 3 ? t[2] : normal;
    const double volume = dot(normal, third);
    Vec3 gradient = along.x * cross(t[1], third) + along.y * cross(third, t[0]);
    if (dimension == 3) gradient = gradient + along.z * normal;
    return dot(gradient, gradient) / (volume * volume);
}

} // namespace

ErrorSums InterpolationCells::sum(const Batch& batch, std::size_t begin, std::size_t end) const {
    ErrorSums sums;
    for (std::size_t i = begin; i < end; ++i) {
        const double e = batch.values[i] - batch.interpolated[i], weight = batch.weight[i];
        const Vec3 gradient = batch.gradients[i];
        const Tangents& t = batch.tangents[i];
        const Vec3 along =
            Vec3{dot(gradient, t[0]), dot(gradient, t[1]), dot(gradient, t[2])} - batch.slopes[i];
        sums.square += weight * e * e;
        sums.slope += weight * slope_square(dimension_, t, along);
        sums.measure += weight;
        sums.maximum = std::max(sums.maximum, std::abs(e));
    }
    return sums;
}

void InterpolationCells::integrate(std::span<const CellPart> parts, Batch& batch,
                                   std::vector<ErrorSums>& sums) const {
    const std::size_t points = parts.size() * rule_.size();
    batch.points.resize(points);
    batch.interpolated.resize(points), batch.weight.resize(points);
    batch.tangents.resize(points), batch.slopes.resize(points);
    Shape further;
    std::size_t slot = 0;
    for (const CellPart& part : parts) {
        const double scale = std::pow(std::abs(part.size), dimension_);
        for (std::size_t q = 0; q < rule_.size(); ++q, ++slot) {
            const bool known = part.halvings <= 1;
            if (!known) set_shape(part.origin + part.size * rule_[q].point, further);
            const Shape& shape = known ? shapes_[part.known][q] : further;
            const Place at = place(batch, part.cell, shape);
            if (!(at.jacobian > 0)) batch.tangled[part.cell] = 1;
            note(batch, slot, part.cell, shape, at, rule_[q].weight * scale * std::abs(at.jacobian));
        }
    }
    evaluate(batch.points, batch.values);
    u_.gradients(batch.points, batch.gradients);
    if (batch.gradients.size() != points)
        throw InputError("the function whose interpolation error is measured has no gradients");
    sums.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        sums[i] = sum(batch, i * rule_.size(), (i + 1) * rule_.size());
}

/// The largest |e| of the grid points, every `stride` of them, and what the parabola through it and its
/// neighbours adds.
double InterpolationCells::peak(const Batch& batch, std::size_t cell, int stride) const {
    const double* values = batch.values.data() + cell * grid_.size();
    const double* interpolated = batch.interpolated.data() + cell * grid_.size();
    std::size_t best = 0;
    const auto error = [&](std::size_t i) { return values[i] - interpolated[i]; };
    for (std::size_t i = 0; i < grid_.size(); ++i) {
        const auto& [a, b, c] = grid_places_[i];
        if (a % stride + b % stride + c % stride > 0) continue;
        if (std::abs(error(i)) > std::abs(error(best))) best = i;
    }
    const double e = std::abs(error(best)), sign = std::copysign(1, error(best));
    const auto at = [&](int i, int j, int k) { // NaN outside
        if (std::min({i, j, k}) < 0 || std::max({i, j, k}) > grid) return std::nan("");
        const int place = grid_of_[grid_index(i, j, k)];
        return place < 0 ? std::nan("") : sign * error(static_cast<std::size_t>(place));
    };
    const auto& [a, b, c] = grid_places_[best];
    const auto gain = [&](int i, int j, int k) { // along one direction
        const double before = at(a - stride * i, b - stride * j, c - stride * k),
                     after = at(a + stride * i, b + stride * j, c + stride * k);
        const double bend = 2 * e - before - after, tilt = after - before;
        return bend > 0 ? tilt * tilt / (8 * bend) : 0;
    };
    if (mesh_.kind.shape == CellShape::triangle)
        return e + std::max({gain(1, 0, 0), gain(0, 1, 0), gain(1, -1, 0)});
    return e + gain(1, 0, 0) + gain(0, 1, 0) + gain(0, 0, 1);
}

void InterpolationCells::peaks(Batch& batch, std::span<Peak> peaks) const {
    const std::size_t cells = batch.end - batch.begin, points = cells * grid_.size();
    batch.points.resize(points);
    batch.interpolated.resize(points), batch.weight.resize(points);
    batch.tangents.resize(points), batch.slopes.resize(points);
    for (std::size_t c = 0; c < cells; ++c) {
        for (std::size_t g = 0; g < grid_.size(); ++g)
            note(batch, c * grid_.size() + g, c, grid_[g], place(batch, c, grid_[g]), 0);
        const double middle = std::abs(place(batch, c, middle_).jacobian);
        for (const Shape& corner : corner_) // an edge may be a single point
            if (!(place(batch, c, corner).jacobian >= -rounding * middle)) batch.tangled[c] = 1;
    }
    evaluate(batch.points, batch.values);
    for (std::size_t c = 0; c < cells; ++c) peaks[c] = {peak(batch, c, 1), peak(batch, c, 2)};
}

} // namespace gaspard
