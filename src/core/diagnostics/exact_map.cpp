#include "core/diagnostics/exact_map.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr std::size_t intervals = 4096;
constexpr double pi = std::numbers::pi, width = pi / intervals;

} // namespace

std::optional<ExactMap> ExactMap::of(const Monitor& monitor) {
    const auto axis = monitor.symmetry_axis();
    if (!axis) return std::nullopt;
    return ExactMap(monitor, (1 / norm(*axis)) * *axis);
}

ExactMap::ExactMap(const Monitor& monitor, Vec3 axis)
    : axis_(axis), density_(2 * intervals + 1), from_0_(intervals + 1, 0.0), from_pi_(intervals + 1, 0.0) {
    const LineQuadrature rule = gauss_legendre(5);
    const std::size_t gauss = rule.points.size();
    std::vector<double> angles;
    for (std::size_t i = 0; i <= 2 * intervals; ++i) angles.push_back(0.5 * width * static_cast<double>(i));
    for (std::size_t i = 0; i < intervals; ++i)
        for (const double point : rule.points) angles.push_back(width * (static_cast<double>(i) + point));
    Points meridian(angles.size());
    const Vec3 across = any_across(axis);
    for (std::size_t i = 0; i < angles.size(); ++i)
        meridian.set(i, std::cos(angles[i]) * axis + std::sin(angles[i]) * across);
    std::vector<double> m(angles.size());
    monitor.values(meridian, m);
    for (std::size_t i = 0; i < angles.size(); ++i) m[i] *= std::max(0.0, std::sin(angles[i]));

    std::copy_n(m.begin(), density_.size(), density_.begin());
    std::vector<double> parts(intervals, 0.0);
    for (std::size_t i = 0; i < intervals; ++i)
        for (std::size_t q = 0; q < gauss; ++q)
            parts[i] += width * rule.weights[q] * m[density_.size() + i * gauss + q];
    for (std::size_t i = 0; i < intervals; ++i) from_0_[i + 1] = from_0_[i] + parts[i];
    for (std::size_t i = intervals; i-- > 0;) from_pi_[i] = from_pi_[i + 1] + parts[i];
    theta_ = from_0_.back() / 2;
}

/// The relative position in [0, 1] at which the integral over an interval reaches `part`. The density is
/// interpolated quadratically and scaled to the tabulated integral.
double ExactMap::within(std::size_t interval, double part) const {
    const double a = density_[2 * interval], b = density_[2 * interval + 1], c = density_[2 * interval + 2];
    const double linear = -3 * a + 4 * b - c, square = 2 * a - 4 * b + 2 * c;
    const auto integral = [&](double u) { return u * (a + u * (linear / 2 + u * square / 3)); };
    const double wanted = part * integral(1);
    double low = 0, high = 1, u = part;
    for (int iteration = 0; iteration < 60 && high - low > 1e-14; ++iteration) {
        const double excess = integral(u) - wanted, slope = a + u * (linear + u * square);
        if (std::abs(excess) <= 1e-16 * integral(1)) break;
        (excess > 0 ? high : low) = u;
        const double next = u - excess / slope;
        u = next > low && next < high ? next : (low + high) / 2;
    }
    return u;
}

double ExactMap::angle(double t) const {
    const bool near = t < pi / 2; // the end from which integrals are measured
    const double half = near ? std::sin(t / 2) : std::cos(t / 2);
    const double wanted = 2 * theta_ * half * half;
    const auto& table = near ? from_0_ : from_pi_;
    std::size_t i = 0; // index of the interval in which the integral reaches `wanted`
    if (near)
        i = static_cast<std::size_t>(std::upper_bound(table.begin(), table.end(), wanted) - table.begin());
    else
        i = static_cast<std::size_t>(std::lower_bound(table.begin(), table.end(), wanted, std::greater<>()) -
                                     table.begin());
    i = std::clamp<std::size_t>(i, 1, intervals) - 1;
    const double whole = std::abs(table[i + 1] - table[i]);
    const double part = whole > 0 ? std::clamp(std::abs(wanted - table[i]) / whole, 0.0, 1.0) : 0;
    return width * (static_cast<double>(i) + within(i, part));
}

Points ExactMap::apply(const Points& xi) const {
    Points x(xi.size());
    for (std::size_t i = 0; i < xi.size(); ++i) {
        const Vec3 p = xi[i];
        const double radius = norm(p), along = dot(p, axis_);
        const Vec3 away = p - along * axis_;
        const double distance = norm(away);
        if (distance < 1e-13 * radius) { // on the axis
            x.set(i, p);
            continue;
        }
        const double s = angle(std::atan2(distance, along));
        x.set(i, radius * (std::cos(s) * axis_ + (std::sin(s) / distance) * away));
    }
    return x;
}

ExactDeviation exact_deviation(const Mesh& mesh, const Points& x, const Points& exact, bool sphere) {
    GASPARD_CHECK(x.size() == mesh.node_count() && exact.size() == x.size());
    std::vector<char> corner(x.size(), 0);
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (const auto node : mesh.cell(c).first(corners)) corner[static_cast<std::size_t>(node)] = 1;
    double of_corners = 0, of_all = 0, count = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double distance =
            sphere ? norm(exact[i]) * angle_between(x[i], exact[i]) : norm(x[i] - exact[i]);
        of_all += distance * distance;
        if (corner[i]) of_corners += distance * distance, ++count;
    }
    return {std::sqrt(of_corners / count), std::sqrt(of_all / static_cast<double>(x.size()))};
}

} // namespace gaspard
