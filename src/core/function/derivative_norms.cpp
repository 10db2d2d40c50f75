#include "core/function/derivative_norms.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr double step_of_size = 2e-5;
constexpr double degenerate = 1e-12; // det g / (trace g)^2 of tangents that are parallel

double& component(Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Vec3 axis_vector(std::size_t axis) {
    Vec3 v;
    component(v, axis) = 1;
    return v;
}

Vec3 unit(Vec3 v) {
    const double length = norm(v);
    return length > 0 ? (1 / length) * v : Vec3{};
}

Vec3 without(Vec3 v, Vec3 n) { return v - dot(v, n) * n; }

} // namespace

DerivativeNorms::DerivativeNorms(const ScalarFunction& u, std::shared_ptr<const Chart> chart, double size,
                                 bool box)
    : u_(u), chart_(std::move(chart)), step_(step_of_size * size), box_(box) {}

/// P grad u.
void DerivativeNorms::tangential(const Points& s, const Points& x, Points& gradients) const {
    u_.gradients(x, gradients);
    GASPARD_CHECK(gradients.size() == x.size());
    if (chart_->kind() == ChartKind::box) return;
    std::array<Points, 3> tangents;
    if (chart_->kind() == ChartKind::surface) chart_->tangents(s, tangents);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 normal =
            chart_->kind() == ChartKind::sphere ? x[i] : cross(tangents[0][i], tangents[1][i]);
        gradients.set(i, without(gradients[i], unit(normal)));
    }
}

void DerivativeNorms::gradients(const Points& s, const Points& x, std::span<double> norms) const {
    Points g;
    tangential(s, x, g);
    for (std::size_t i = 0; i < norms.size(); ++i) norms[i] = norm(g[i]);
}

/// Orthonormal tangents; zero where those of the chart are parallel.
void DerivativeNorms::frame(const Points& s, const Points& x, Points& first, Points& second) const {
    first = Points(x.size()), second = Points(x.size());
    std::array<Points, 3> tangents;
    if (chart_->kind() == ChartKind::surface) chart_->tangents(s, tangents);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (chart_->kind() == ChartKind::sphere) {
            const Vec3 n = unit(x[i]), across = any_across(n);
            first.set(i, across), second.set(i, cross(n, across));
            continue;
        }
        const Vec3 a = tangents[0][i], b = tangents[1][i], normal = cross(a, b);
        const double trace = dot(a, a) + dot(b, b);
        if (!(dot(normal, normal) > degenerate * trace * trace)) continue;
        first.set(i, unit(a)), second.set(i, unit(without(b, unit(a))));
    }
}

/// Moves points of the domain along tangents of length 1.
void DerivativeNorms::shift(const Points& s, const Points& x, const Points& direction, double length,
                            Points& moved_s, Points& moved_x) const {
    moved_s = s, moved_x = Points(x.size());
    std::array<Points, 3> tangents;
    if (chart_->kind() == ChartKind::surface) chart_->tangents(s, tangents);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 to = x[i] + length * direction[i];
        if (chart_->kind() == ChartKind::sphere) moved_x.set(i, (norm(x[i]) / norm(to)) * to);
        if (chart_->kind() != ChartKind::surface) continue;
        const Vec3 a = tangents[0][i], b = tangents[1][i], d = direction[i];
        const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), determinant = aa * bb - ab * ab;
        if (!(determinant > degenerate * (aa + bb) * (aa + bb))) continue;
        const double along_a = (bb * dot(a, d) - ab * dot(b, d)) / determinant;
        const double along_b = (aa * dot(b, d) - ab * dot(a, d)) / determinant;
        const auto clamped = [&](double at, std::size_t axis) {
            return std::clamp(at, chart_->direction(axis).low, chart_->direction(axis).high);
        };
        moved_s.x[i] = clamped(s.x[i] + length * along_a, 0);
        moved_s.y[i] = clamped(s.y[i] + length * along_b, 1);
    }
    if (chart_->kind() == ChartKind::surface) chart_->points(moved_s, moved_x);
    if (chart_->kind() != ChartKind::box) return;
    for (std::size_t i = 0; i < x.size(); ++i) {
        Vec3 to = x[i] + length * direction[i];
        for (std::size_t axis = 0; box_ && axis < chart_->dimension(); ++axis)
            if (const ChartDirection& d = chart_->direction(axis); d.ends == ChartEnds::open)
                component(to, axis) = std::clamp(component(to, axis), d.low, d.high);
        moved_x.set(i, to), moved_s.set(i, to);
    }
}

/// Points at which u has no gradient, beside the domain, become those of the domain: the difference is
/// one-sided.
void DerivativeNorms::keep_finite(const Points& s, const Points& x, Points& moved, Points& gradients) const {
    const auto is_finite = [&](std::size_t i) { return std::isfinite(norm(gradients[i])); };
    bool all = true;
    for (std::size_t i = 0; i < x.size(); ++i) all = all && is_finite(i);
    if (all) return;
    Points here;
    tangential(s, x, here);
    for (std::size_t i = 0; i < x.size(); ++i)
        if (!is_finite(i)) moved.set(i, x[i]), gradients.set(i, here[i]);
}

void DerivativeNorms::hessians(const Points& s, const Points& x, std::span<double> norms) const {
    std::fill(norms.begin(), norms.end(), 0.0);
    std::array<Points, 3> directions;
    const bool flat = chart_->kind() == ChartKind::box;
    const std::size_t count = flat ? chart_->dimension() : 2;
    if (!flat) frame(s, x, directions[0], directions[1]);
    for (std::size_t axis = 0; flat && axis < count; ++axis) {
        directions[axis] = Points(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) directions[axis].set(i, axis_vector(axis));
    }
    Points s_back, x_back, s_on, x_on, g_back, g_on;
    for (std::size_t a = 0; a < count; ++a) {
        shift(s, x, directions[a], -step_, s_back, x_back);
        shift(s, x, directions[a], step_, s_on, x_on);
        tangential(s_back, x_back, g_back);
        tangential(s_on, x_on, g_on);
        keep_finite(s, x, x_back, g_back);
        keep_finite(s, x, x_on, g_on);
        for (std::size_t i = 0; i < x.size(); ++i) {
            double distance = norm(x_on[i] - x_back[i]);
            if (!(distance > 0)) continue;           // where the chart is degenerate
            if (chart_->kind() == ChartKind::sphere) // along the arc
                distance = 2 * norm(x[i]) * std::asin(distance / (2 * norm(x[i])));
            const Vec3 change = (1 / distance) * (g_on[i] - g_back[i]);
            for (std::size_t b = 0; b < count; ++b) {
                const double entry = dot(change, directions[b][i]);
                norms[i] += entry * entry;
            }
        }
    }
    for (double& one : norms) one = std::sqrt(one);
}

} // namespace gaspard
