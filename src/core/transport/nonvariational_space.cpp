#include "core/transport/nonvariational_space.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/fem/cell_quadrature.hpp"
#include "core/fem/gauss.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace gaspard {

namespace {

/// Six points, exact for degree 4 (Strang, Fix, 1973).
std::vector<CellPoint> quadrature_of_degree_4() {
    struct Orbit {
        double a, weight;
    };
    constexpr Orbit orbits[] = {{0.44594849091596488632, 0.22338158967801146570},
                                {0.09157621350977074346, 0.10995174365532186764}};
    std::vector<CellPoint> points;
    for (const auto& [a, weight] : orbits) {
        points.push_back({{a, a, 0}, weight / 2});
        points.push_back({{1 - 2 * a, a, 0}, weight / 2});
        points.push_back({{a, 1 - 2 * a, 0}, weight / 2});
    }
    return points;
}

/// Exact for (det H, v) on straight triangles, of degree 3 k.
std::vector<CellPoint> rule_of(int degree) {
    if (degree == 1) return quadrature_of_degree_4();
    return degree == 2 ? quadrature_of_degree_8(CellShape::triangle)
                       : cell_quadrature(CellShape::triangle, 7);
}

CellUnknowns unknowns_of(const LagrangeTriangles& elements) {
    CellUnknowns unknowns{.count = elements.nodes().size(), .per_cell = elements.per_cell(), .numbers = {}};
    for (std::size_t c = 0; c < elements.cell_count(); ++c) {
        const auto cell = elements.cell(c);
        unknowns.numbers.insert(unknowns.numbers.end(), cell.begin(), cell.end());
    }
    return unknowns;
}

NonvariationalSpace::Point point_of(const LagrangeTriangles::Place& place, double weight) {
    const double j = place.jacobian();
    return {weight * j, {place.by_t[1] / j, -place.by_t[0] / j, -place.by_s[1] / j, place.by_s[0] / j}};
}

/// In a loop over many cells.
void look_at(const std::stop_token& stop, std::size_t cell) {
    if (cell % 1024 == 0 && stop.stop_requested()) throw Interrupted();
}

} // namespace

NonvariationalSpace::NonvariationalSpace(LagrangeTriangles elements, Recovery recovery, std::stop_token stop)
    : elements_(std::move(elements)), recovery_(recovery), unknowns_(unknowns_of(elements_)),
      pattern_(unknowns_) {
    make_points(stop);
    dissection_ = std::make_shared<const Dissection>(dissect(unknowns_, middles_));
    make_operators(stop);
    if (recovery_ == Recovery::none) add_side_terms();
    const std::size_t n = elements_.per_cell();
    mass_ = std::make_unique<const CellCholesky>(
        unknowns_, dissection_,
        [&](std::size_t cell, std::span<double> matrix) {
            std::fill(matrix.begin(), matrix.end(), 0.0);
            for (std::size_t q = 0; q < shapes_.size(); ++q)
                for (std::size_t a = 0; a < n; ++a)
                    for (std::size_t b = 0; b < n; ++b)
                        matrix[a * n + b] +=
                            points(cell)[q].weight * shapes_[q].values[a] * shapes_[q].values[b];
        },
        CellCholesky::Advance{}, std::move(stop));
}

void NonvariationalSpace::make_points(const std::stop_token& stop) {
    const int degree = elements_.degree();
    for (const CellPoint& point : rule_of(degree)) {
        shapes_.push_back(triangle_shapes(degree, point.point.x, point.point.y));
        weights_.push_back(point.weight);
    }
    const LineQuadrature line = gauss_legendre(degree + 2);
    side_weights_ = line.weights;
    for (int edge = 0; edge < 3; ++edge)
        for (const double r : line.points) {
            const auto [s, t] = LagrangeTriangles::on_edge(edge, r);
            side_shapes_[static_cast<std::size_t>(edge)].push_back(triangle_shapes(degree, s, t));
        }
    middles_ = Points(elements_.cell_count());
    const TriangleShapes middle = triangle_shapes(degree, 1.0 / 3, 1.0 / 3);
    for (std::size_t c = 0; c < elements_.cell_count(); ++c) {
        look_at(stop, c);
        middles_.set(c, elements_.place(c, middle).x);
        for (std::size_t q = 0; q < shapes_.size(); ++q)
            points_.push_back(point_of(elements_.place(c, shapes_[q]), weights_[q]));
    }
    for (const auto& [cell, edge] : elements_.sides())
        for (std::size_t q = 0; q < side_weights_.size(); ++q) {
            const auto place = elements_.place(cell, side_shapes(edge)[q]);
            std::array<double, 2> along{};
            for (std::size_t i = 0; i < 2; ++i)
                along[i] = edge == 0   ? place.by_s[i]
                           : edge == 1 ? place.by_t[i] - place.by_s[i]
                                       : -place.by_t[i];
            const double length = std::hypot(along[0], along[1]);
            SidePoint point{point_of(place, 0), {along[1] / length, -along[0] / length}};
            point.point.weight = side_weights_[q] * length;
            side_points_.push_back(point);
        }
}

void NonvariationalSpace::make_operators(const std::stop_token& stop) {
    const std::size_t n = elements_.per_cell();
    loads_.assign(size(), 0);
    slopes_.assign(2 * pattern_.entries(), 0);
    if (recovery_ == Recovery::none) hessians_.assign(3 * pattern_.entries(), 0);
    std::vector<std::array<double, 2>> gradients(n);
    for (std::size_t c = 0; c < elements_.cell_count(); ++c) {
        look_at(stop, c);
        const auto slots = pattern_.slots(c);
        for (std::size_t q = 0; q < shapes_.size(); ++q) {
            const Point& point = points(c)[q];
            const auto& values = shapes_[q].values;
            for (std::size_t a = 0; a < n; ++a) gradients[a] = point.gradient(shapes_[q].slopes[a]);
            for (std::size_t a = 0; a < n; ++a) {
                loads_[static_cast<std::size_t>(elements_.cell(c)[a])] += point.weight * values[a];
                for (std::size_t b = 0; b < n; ++b) {
                    double* to = slopes_.data() + 2 * slots[a * n + b];
                    to[0] += point.weight * values[a] * gradients[b][0];
                    to[1] += point.weight * values[a] * gradients[b][1];
                    if (recovery_ != Recovery::none) continue;
                    double* h = hessians_.data() + 3 * slots[a * n + b];
                    h[0] -= point.weight * gradients[a][0] * gradients[b][0];
                    h[1] -= 0.5 * point.weight *
                            (gradients[a][1] * gradients[b][0] + gradients[a][0] * gradients[b][1]);
                    h[2] -= point.weight * gradients[a][1] * gradients[b][1];
                }
            }
        }
    }
    area_ = std::accumulate(loads_.begin(), loads_.end(), 0.0);
}

/// <d_a u, n_b v> of (39).
void NonvariationalSpace::add_side_terms() {
    const std::size_t n = elements_.per_cell();
    for (std::size_t i = 0; i < elements_.sides().size(); ++i) {
        const auto& [cell, edge] = elements_.sides()[i];
        const auto slots = pattern_.slots(cell);
        for (std::size_t q = 0; q < side_weights_.size(); ++q) {
            const auto& [point, normal] = side_points(i)[q];
            const TriangleShapes& at = side_shapes(edge)[q];
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b) {
                    const auto gradient = point.gradient(at.slopes[b]);
                    const double v = point.weight * at.values[a];
                    double* h = hessians_.data() + 3 * slots[a * n + b];
                    h[0] += v * gradient[0] * normal[0];
                    h[1] += 0.5 * v * (gradient[0] * normal[1] + gradient[1] * normal[0]);
                    h[2] += v * gradient[1] * normal[1];
                }
        }
    }
}

void NonvariationalSpace::project(std::vector<double>& four) const {
    std::vector<double> ordered(four.size());
    const auto& place = dissection_->permutation;
    for (std::size_t i = 0; i < size(); ++i)
        std::copy_n(four.data() + 4 * i, 4, ordered.data() + 4 * static_cast<std::size_t>(place[i]));
    mass_->solve<4>(ordered);
    for (std::size_t i = 0; i < size(); ++i)
        std::copy_n(ordered.data() + 4 * static_cast<std::size_t>(place[i]), 4, four.data() + 4 * i);
}

void NonvariationalSpace::differentiate(std::span<const double> u, std::vector<double>& derivatives) const {
    derivatives.resize(derivative_count * size());
    std::vector<double> four(4 * size(), 0.0), g(2 * size()), h(3 * size());
    pattern_.each<2>(slopes_, u, g);
    for (std::size_t i = 0; i < size(); ++i) std::copy_n(g.data() + 2 * i, 2, four.data() + 4 * i);
    project(four);
    for (std::size_t i = 0; i < size(); ++i) {
        derivatives[derivative_count * i + g1] = four[4 * i];
        derivatives[derivative_count * i + g2] = four[4 * i + 1];
    }
    if (recovery_ == Recovery::none) {
        pattern_.each<3>(hessians_, u, h);
    } else {
        std::vector<double> one(size()), by(2 * size());
        for (std::size_t c = 0; c < 2; ++c) {
            for (std::size_t i = 0; i < size(); ++i) one[i] = four[4 * i + c];
            pattern_.each<2>(slopes_, one, by);
            for (std::size_t i = 0; i < size(); ++i) {
                if (c == 0) h[3 * i] = by[2 * i], h[3 * i + 1] = 0.5 * by[2 * i + 1];
                if (c == 1) h[3 * i + 1] += 0.5 * by[2 * i], h[3 * i + 2] = by[2 * i + 1];
            }
        }
    }
    for (std::size_t i = 0; i < size(); ++i) {
        std::copy_n(h.data() + 3 * i, 3, four.data() + 4 * i);
        four[4 * i + 3] = 0;
    }
    project(four);
    for (std::size_t i = 0; i < size(); ++i)
        std::copy_n(four.data() + 4 * i, 3, derivatives.data() + derivative_count * i);
}

Points NonvariationalSpace::positions() const {
    Points x(points_.size());
    for (std::size_t c = 0; c < elements_.cell_count(); ++c)
        for (std::size_t q = 0; q < shapes_.size(); ++q)
            x.set(c * shapes_.size() + q, elements_.place(c, shapes_[q]).x);
    return x;
}

} // namespace gaspard
