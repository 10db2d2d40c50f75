#include "core/transport/transport_form.hpp"

#include "core/base/check.hpp"
#include "core/base/eigenvalues.hpp"
#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"
#include "core/fem/gauss.hpp"
#include "core/transport/curve_integral.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace gaspard {

namespace {

/// The Bernstein polynomials of degree k at the points of a rule, by the nodes to which they belong.
std::vector<std::vector<double>> bernstein_at(const NonvariationalSpace& space) {
    const int k = space.elements().degree();
    const auto corners = [](const TriangleShapes& linear) { return linear.values; };
    std::vector<std::vector<double>> all;
    for (const TriangleShapes& shapes : space.shapes()) {
        if (k == 1) {
            all.push_back(corners(shapes));
            continue;
        }
        // Barycentric coordinates from the shape functions, which reproduce them.
        std::array<double, 3> l{};
        const auto at = lagrange_lattice(k);
        for (std::size_t a = 0; a < at.size(); ++a)
            for (std::size_t c = 0; c < 3; ++c) l[c] += shapes.values[a] * at[a][c] / k;
        std::vector<double> values;
        for (const auto& node : at) {
            constexpr double factorial[] = {1, 1, 2, 6};
            double value = factorial[k];
            for (std::size_t c = 0; c < 3; ++c) value *= std::pow(l[c], node[c]) / factorial[node[c]];
            values.push_back(value);
        }
        all.push_back(std::move(values));
    }
    return all;
}

void require_positive(std::span<const double> values, const char* what) {
    for (const double value : values)
        if (!(value > 0) || !std::isfinite(value))
            throw InputError(std::string("the density on the ") + what +
                             " must be positive and finite everywhere, but is " + exact_number(value) +
                             " at some point; add a floor to it");
}

std::vector<double> values_of(const std::shared_ptr<const Monitor>& density, const Points& x,
                              const char* what) {
    std::vector<double> values(x.size(), 1.0);
    if (!density) return values;
    density->values(x, values);
    require_positive(values, what);
    return values;
}

} // namespace

TransportForm::TransportForm(std::shared_ptr<const NonvariationalSpace> space,
                             std::shared_ptr<const ConvexCurve> source,
                             std::shared_ptr<const ConvexCurve> target)
    : space_(std::move(space)), source_(std::move(source)), target_(std::move(target)),
      bernstein_(bernstein_at(*space_)), residual_(size()) {
    inner_radius_ = std::numeric_limits<double>::infinity();
    constexpr int samples = 256;
    for (int i = 0; i < samples; ++i) {
        const auto gauge = target_->gauge(target_->point(static_cast<double>(i) / samples));
        inner_radius_ = std::min(inner_radius_, 0.999 / norm(gauge.gradient));
    }
}

std::vector<double> TransportForm::start() {
    // The moments of the source, from its mesh.
    const Points x = space_->positions();
    double area = 0;
    Vec3 middle{};
    Covariance of_source{};
    const std::size_t rule = space_->shapes().size();
    const auto weight = [&](std::size_t i) { return space_->points(i / rule)[i % rule].weight; };
    for (std::size_t i = 0; i < x.size(); ++i) area += weight(i), middle = middle + weight(i) * x[i];
    middle = (1 / area) * middle;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 d = x[i] - middle;
        of_source.xx += weight(i) * d.x * d.x / area;
        of_source.xy += weight(i) * d.x * d.y / area;
        of_source.yy += weight(i) * d.y * d.y / area;
    }
    const Covariance a = transport_of_covariances(of_source, target_->covariance());
    std::vector<double> u(size(), 0.0);
    double mean = 0;
    const Points& nodes = space_->elements().nodes();
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
        const Vec3 d = nodes[i] - middle;
        u[i] = dot(target_->centre(), d) + 0.5 * (a.xx * d.x * d.x + 2 * a.xy * d.x * d.y + a.yy * d.y * d.y);
        mean += u[i] * space_->loads()[i] / space_->area();
    }
    for (std::size_t i = 0; i + 1 < u.size(); ++i) u[i] -= mean;
    evaluate({}, u);
    scale_ = scale_of_iterate();
    return u;
}

std::vector<double> TransportForm::identity() const {
    std::vector<double> u(size(), 0.0);
    const Points& nodes = space_->elements().nodes();
    double mean = 0;
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
        u[i] = 0.5 * dot(nodes[i], nodes[i]);
        mean += u[i] * space_->loads()[i] / space_->area();
    }
    for (std::size_t i = 0; i + 1 < u.size(); ++i) u[i] -= mean;
    return u;
}

double TransportForm::scale_of_iterate() const {
    double of_cofactor = 0, of_boundary = 0;
    for (std::size_t i = 0; i < space_->elements().sides().size(); ++i) {
        const auto& [cell, edge] = space_->elements().sides()[i];
        const auto numbers = space_->elements().cell(cell);
        for (std::size_t q = 0; q < space_->side_shapes(edge).size(); ++q) {
            const TriangleShapes& shapes = space_->side_shapes(edge)[q];
            const auto& [point, n] = space_->side_points(i)[q];
            std::array<double, 3> h{};
            for (std::size_t a = 0; a < numbers.size(); ++a)
                for (std::size_t c = 0; c < 3; ++c)
                    h[c] += shapes.values[a] *
                            derivatives_[derivative_count * static_cast<std::size_t>(numbers[a]) + c];
            const auto g = gradient_at(numbers, shapes, point);
            of_cofactor +=
                point.weight * std::hypot(h[h22] * n[0] - h[h12] * n[1], h[h11] * n[1] - h[h12] * n[0]);
            of_boundary += point.weight * norm(boundary({g[0], g[1], 0}).gradient) / scale_;
        }
    }
    return of_cofactor / of_boundary;
}

TransportForm::Boundary TransportForm::boundary(Vec3 p) const {
    const auto gauge = target_->gauge(p);
    return {scale_ * (1 - gauge.value * gauge.value) / 2, (-scale_ * gauge.value) * gauge.gradient};
}

Vec3 TransportForm::into_target(Vec3 p) const {
    const Vec3 from = p - target_->centre();
    if (!std::isfinite(from.x + from.y)) return target_->centre(); // the residual is not finite then
    if (norm(from) <= inner_radius_) return p;
    const double gauge = target_->gauge(p).value;
    return gauge <= 1 ? p : target_->centre() + (1 / gauge) * from;
}

/// Masses, and the source's density at the points.
void TransportForm::take(const TransportDensities& densities) {
    if (known_ && densities == densities_) return;
    known_ = false; // until nothing can throw any more
    rho_ = values_of(densities.source, space_->positions(), "source");
    const auto mass = [](const ConvexCurve& curve, const std::shared_ptr<const Monitor>& density,
                         const char* what) {
        if (!density) return curve.area();
        const WeightedPoints rule = points_within(curve);
        const std::vector<double> values = values_of(density, rule.x, what);
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) sum += rule.weights[i] * values[i];
        return sum;
    };
    double of_source = 0;
    if (source_) {
        of_source = mass(*source_, densities.source, "source");
    } else {
        const std::size_t rule = space_->shapes().size();
        for (std::size_t i = 0; i < rho_.size(); ++i)
            of_source += space_->points(i / rule)[i % rule].weight * rho_[i];
    }
    theta_ = mass(*target_, densities.target, "target") / of_source;
    for (double& value : rho_) value *= theta_;
    densities_ = densities;
    known_ = true;
}

std::array<double, 2> TransportForm::gradient_at(std::span<const std::int32_t> cell,
                                                 const TriangleShapes& shapes,
                                                 const NonvariationalSpace::Point& point) const {
    std::array<double, 2> g{};
    for (std::size_t a = 0; a < cell.size(); ++a) {
        const auto node = static_cast<std::size_t>(cell[a]);
        if (space_->recovery() == Recovery::gradient) {
            g[0] += shapes.values[a] * derivatives_[derivative_count * node + g1];
            g[1] += shapes.values[a] * derivatives_[derivative_count * node + g2];
        } else {
            const auto slope = point.gradient(shapes.slopes[a]);
            g[0] += slope[0] * unknowns_[node], g[1] += slope[1] * unknowns_[node];
        }
    }
    return g;
}

void TransportForm::evaluate(const TransportDensities& densities, std::span<const double> unknowns) {
    GASPARD_CHECK(unknowns.size() == size());
    take(densities);
    unknowns_.assign(unknowns.begin(), unknowns.end());
    space_->differentiate(unknowns.first(space_->size()), derivatives_);
    evaluate_target();
    std::fill(residual_.begin(), residual_.end(), 0.0);
    add_cells();
    add_sides();
    for (std::size_t i = 0; i < space_->size(); ++i) {
        residual_[i] += unknowns_.back() * space_->loads()[i];
        residual_.back() += unknowns_[i] * space_->loads()[i];
    }
    find_convexity();
}

void TransportForm::evaluate_target() {
    const LagrangeTriangles& elements = space_->elements();
    const std::size_t rule = space_->shapes().size();
    if (!densities_.target) {
        sigma_.assign(elements.cell_count() * rule, 1.0);
        return;
    }
    images_.resize(elements.cell_count() * rule);
    for (std::size_t c = 0; c < elements.cell_count(); ++c)
        for (std::size_t q = 0; q < rule; ++q) {
            const auto g = gradient_at(elements.cell(c), space_->shapes()[q], space_->points(c)[q]);
            images_.set(c * rule + q, into_target({g[0], g[1], 0}));
        }
    sigma_.resize(images_.size());
    densities_.target->values(images_, sigma_);
    require_positive(sigma_, "target");
}

void TransportForm::add_cells() {
    const LagrangeTriangles& elements = space_->elements();
    const std::size_t n = elements.per_cell(), rule = space_->shapes().size();
    for (std::size_t c = 0; c < elements.cell_count(); ++c) {
        const auto cell = elements.cell(c);
        for (std::size_t q = 0; q < rule; ++q) {
            const auto& values = space_->shapes()[q].values;
            std::array<double, 3> h{};
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t i = 0; i < 3; ++i)
                    h[i] +=
                        values[a] * derivatives_[derivative_count * static_cast<std::size_t>(cell[a]) + i];
            const double f = space_->points(c)[q].weight *
                             (h[h11] * h[h22] - h[h12] * h[h12] - rho_[c * rule + q] / sigma_[c * rule + q]);
            for (std::size_t a = 0; a < n; ++a) residual_[static_cast<std::size_t>(cell[a])] += f * values[a];
        }
    }
}

void TransportForm::add_sides() {
    const LagrangeTriangles& elements = space_->elements();
    for (std::size_t i = 0; i < elements.sides().size(); ++i) {
        const auto& [c, edge] = elements.sides()[i];
        const auto cell = elements.cell(c);
        for (std::size_t q = 0; q < space_->side_shapes(edge).size(); ++q) {
            const TriangleShapes& shapes = space_->side_shapes(edge)[q];
            const auto& point = space_->side_points(i)[q].point;
            const auto g = gradient_at(cell, shapes, point);
            const double f = point.weight * boundary({g[0], g[1], 0}).value;
            for (std::size_t a = 0; a < cell.size(); ++a)
                residual_[static_cast<std::size_t>(cell[a])] += f * shapes.values[a];
        }
    }
}

void TransportForm::find_convexity() {
    const LagrangeTriangles& elements = space_->elements();
    const std::size_t n = elements.per_cell();
    std::vector<std::array<double, 4>> means(space_->size());
    for (std::size_t c = 0; c < elements.cell_count(); ++c) {
        const auto cell = elements.cell(c);
        for (std::size_t q = 0; q < space_->shapes().size(); ++q) {
            const double weight = space_->points(c)[q].weight;
            std::array<double, 3> h{};
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t i = 0; i < 3; ++i)
                    h[i] += space_->shapes()[q].values[a] *
                            derivatives_[derivative_count * static_cast<std::size_t>(cell[a]) + i];
            for (std::size_t a = 0; a < n; ++a) {
                auto& mean = means[static_cast<std::size_t>(cell[a])];
                const double w = weight * bernstein_[q][a];
                for (std::size_t i = 0; i < 3; ++i) mean[i] += w * h[i];
                mean[3] += w;
            }
        }
    }
    convexity_ = std::numeric_limits<double>::infinity();
    for (const auto& [xx, xy, yy, weight] : means) {
        const double low = symmetric_eigenvalues(xx, xy, yy).smallest / weight;
        if (!(low >= convexity_)) convexity_ = low; // also NaN
    }
}

double TransportForm::normalised_residual() const {
    double sum = 0, of_loads = 0;
    for (std::size_t i = 0; i < space_->size(); ++i) {
        sum += residual_[i] * residual_[i];
        of_loads += space_->loads()[i] * space_->loads()[i];
    }
    const double mean = target_->area() / space_->area();
    return std::sqrt(sum / of_loads) / mean;
}

std::vector<double> TransportForm::boundary_defects(std::span<const double> derivatives) const {
    const auto degree = static_cast<std::size_t>(space_->elements().degree());
    std::vector<double> defects(space_->size(), 0.0);
    for (const auto& [cell, edge] : space_->elements().sides())
        for (std::size_t i = 0; i < degree; ++i) { // the first corner, and the nodes between
            const auto first = static_cast<std::size_t>(edge);
            const std::size_t at = i == 0 ? first : 3 + first * (degree - 1) + i - 1;
            const auto node = static_cast<std::size_t>(space_->elements().cell(cell)[at]);
            const double* d = derivatives.data() + derivative_count * node;
            const Boundary here = boundary({d[g1], d[g2], 0});
            defects[node] = std::abs(here.value) / norm(here.gradient);
        }
    return defects;
}

double TransportForm::boundary_defect() const {
    const std::vector<double> defects = boundary_defects(derivatives_);
    return *std::max_element(defects.begin(), defects.end());
}

double TransportForm::image_area(std::span<const double> derivatives) const {
    double twice = 0; // the integral of x dy - y dx
    for (const auto& [c, edge] : space_->elements().sides()) {
        const auto cell = space_->elements().cell(c);
        constexpr std::array<std::array<double, 2>, 3> along = {{{1, 0}, {-1, 1}, {0, -1}}};
        const auto& direction = along[static_cast<std::size_t>(edge)];
        const LineQuadrature rule = gauss_legendre(space_->elements().degree() + 2);
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const TriangleShapes& shapes = space_->side_shapes(edge)[q];
            Vec3 p{}, slope{};
            for (std::size_t a = 0; a < cell.size(); ++a) {
                const double* d = derivatives.data() + derivative_count * static_cast<std::size_t>(cell[a]);
                const Vec3 g{d[g1], d[g2], 0};
                p = p + shapes.values[a] * g;
                slope = slope + (shapes.slopes[a][0] * direction[0] + shapes.slopes[a][1] * direction[1]) * g;
            }
            twice += rule.weights[q] * cross(p, slope).z;
        }
    }
    return twice / 2;
}

void TransportForm::linearise() {
    const LagrangeTriangles& elements = space_->elements();
    const CellPattern& pattern = space_->pattern();
    const std::size_t n = elements.per_cell(), rule = space_->shapes().size();
    const bool recovered = space_->recovery() == Recovery::gradient;
    values_.assign(derivative_count * pattern.entries(), 0.0);
    if (!recovered) direct_.assign(pattern.entries(), 0.0);
    Points slopes;
    if (densities_.target) densities_.target->gradients(images_, slopes);
    const auto add = [&](std::uint32_t slot, const TriangleShapes& shapes, std::size_t a, std::size_t b,
                         const NonvariationalSpace::Point& point, double along1, double along2) {
        if (recovered) { // (along . G w, v)
            const double vw = shapes.values[a] * shapes.values[b];
            values_[derivative_count * slot + g1] += along1 * vw;
            values_[derivative_count * slot + g2] += along2 * vw;
        } else {
            const auto slope = point.gradient(shapes.slopes[b]);
            direct_[slot] += shapes.values[a] * (along1 * slope[0] + along2 * slope[1]);
        }
    };
    for (std::size_t c = 0; c < elements.cell_count(); ++c) {
        const auto cell = elements.cell(c);
        const auto slots = pattern.slots(c);
        for (std::size_t q = 0; q < rule; ++q) {
            const TriangleShapes& shapes = space_->shapes()[q];
            const auto& point = space_->points(c)[q];
            std::array<double, 3> h{};
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t i = 0; i < 3; ++i)
                    h[i] += shapes.values[a] *
                            derivatives_[derivative_count * static_cast<std::size_t>(cell[a]) + i];
            const std::size_t at = c * rule + q;
            const double by_sigma = rho_[at] / (sigma_[at] * sigma_[at]) * point.weight;
            const bool steep = slopes.size() > 0;
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b) {
                    const std::uint32_t slot = slots[a * n + b];
                    const double vw = point.weight * shapes.values[a] * shapes.values[b];
                    double* to = values_.data() + derivative_count * slot;
                    to[h11] += vw * h[h22], to[h12] -= 2 * vw * h[h12], to[h22] += vw * h[h11];
                    if (steep)
                        add(slot, shapes, a, b, point, by_sigma * slopes.x[at], by_sigma * slopes.y[at]);
                }
        }
    }
    for (std::size_t i = 0; i < elements.sides().size(); ++i) {
        const auto& [c, edge] = elements.sides()[i];
        const auto slots = pattern.slots(c);
        for (std::size_t q = 0; q < space_->side_shapes(edge).size(); ++q) {
            const TriangleShapes& shapes = space_->side_shapes(edge)[q];
            const auto& point = space_->side_points(i)[q].point;
            const auto g = gradient_at(elements.cell(c), shapes, point);
            const Vec3 along = boundary({g[0], g[1], 0}).gradient;
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b)
                    add(slots[a * n + b], shapes, a, b, point, point.weight * along.x,
                        point.weight * along.y);
        }
    }
}

void TransportForm::derivative(std::span<const double> w, std::span<double> out) {
    const std::size_t n = space_->size();
    const auto of_u = w.first(n);
    space_->differentiate(of_u, of_w_);
    sum_.resize(n);
    space_->pattern().sum<derivative_count>(values_, of_w_, sum_);
    out[n] = 0;
    for (std::size_t i = 0; i < n; ++i) {
        out[i] = -sum_[i] - w[n] * space_->loads()[i];
        out[n] -= w[i] * space_->loads()[i];
    }
    if (space_->recovery() == Recovery::gradient) return;
    space_->pattern().sum<1>(direct_, of_u, sum_);
    for (std::size_t i = 0; i < n; ++i) out[i] -= sum_[i];
}

} // namespace gaspard
