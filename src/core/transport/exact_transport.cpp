#include "core/transport/exact_transport.hpp"

#include "core/fem/gauss.hpp"
#include "core/transport/curve_integral.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace gaspard {

namespace {

constexpr double equal = 1e-9; ///< relative difference that counts as none

bool is_disk(const ConvexCurve& curve) {
    const Covariance c = curve.covariance();
    return curve.is_ellipse() && std::abs(c.xx - c.yy) + std::abs(c.xy) <= equal * c.xx;
}

enum class Symmetry { none, radial, constant };

/// Points on a spiral, of which no two are in the same direction, against those at the same distances on one
/// ray.
Symmetry symmetry_of(const std::shared_ptr<const Monitor>& density, const ConvexCurve& curve) {
    if (!density) return Symmetry::constant;
    constexpr std::size_t count = 10000;
    const double radius = 2 * std::sqrt(curve.covariance().xx); // of a disk
    Points spiral(count), ray(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double r = std::sqrt((static_cast<double>(i) + 0.5) / count);
        const double t = std::fmod(static_cast<double>(i) / std::numbers::phi, 1.0);
        spiral.set(i, curve.centre() + r * (curve.point(t) - curve.centre()));
        ray.set(i, curve.centre() + Vec3{r * radius, 0, 0});
    }
    std::vector<double> m(count), along(count);
    density->values(spiral, m);
    const auto [low, high] = std::minmax_element(m.begin(), m.end());
    if (*high - *low <= equal * *high) return Symmetry::constant;
    if (!is_disk(curve)) return Symmetry::none;
    density->values(ray, along);
    for (std::size_t i = 0; i < count; ++i)
        if (!(std::abs(m[i] - along[i]) <= equal * m[i])) return Symmetry::none;
    return Symmetry::radial;
}

/// The integral of m s ds over [0, r] on a disk, at equal distances of r, and m there.
struct RadialMass {
    std::size_t parts = 0;
    double width = 0; ///< of a part
    std::vector<double> density, mass;

    RadialMass(const std::shared_ptr<const Monitor>& monitor, const ConvexCurve& disk, std::size_t count)
        : parts(count), width(2 * std::sqrt(disk.covariance().xx) / static_cast<double>(count)),
          density(count + 1, 1.0), mass(count + 1, 0.0) {
        const LineQuadrature rule = gauss_legendre(4);
        const std::size_t per_part = rule.points.size();
        std::vector<double> r;
        for (std::size_t i = 0; i < parts; ++i)
            for (const double p : rule.points) r.push_back((static_cast<double>(i) + p) * width);
        for (std::size_t i = 0; i <= parts; ++i) r.push_back(static_cast<double>(i) * width);
        std::vector<double> m(r.size(), 1.0);
        if (monitor) {
            Points x(r.size());
            for (std::size_t i = 0; i < r.size(); ++i) x.set(i, disk.centre() + Vec3{r[i], 0, 0});
            monitor->values(x, m);
        }
        for (std::size_t i = 0; i < parts; ++i) {
            mass[i + 1] = mass[i];
            for (std::size_t q = 0; q < per_part; ++q)
                mass[i + 1] += width * rule.weights[q] * m[i * per_part + q] * r[i * per_part + q];
        }
        std::copy(m.begin() + static_cast<std::ptrdiff_t>(parts * per_part), m.end(), density.begin());
    }
    /// Cubic between the parts' ends, whose slope m r is known.
    double at(double r) const {
        const auto i = std::min(static_cast<std::size_t>(r / width), parts - 1);
        const double t = r / width - static_cast<double>(i), s = 1 - t;
        const auto slope = [&](std::size_t k) { return density[k] * static_cast<double>(k) * width * width; };
        return mass[i] * s * s * (1 + 2 * t) + mass[i + 1] * t * t * (3 - 2 * t) + slope(i) * t * s * s -
               slope(i + 1) * t * t * s;
    }
    /// The r at which at() has a value.
    double radius(double value) const {
        double low = 0, high = width * static_cast<double>(parts);
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (at(middle) < value ? low : high) = middle;
        }
        return high;
    }
};

/// With as many parts as an error of 1e-10 of the whole takes; null if that is too many.
std::shared_ptr<const RadialMass> radial_mass(const std::shared_ptr<const Monitor>& monitor,
                                              const ConvexCurve& disk) {
    auto coarse = std::make_shared<const RadialMass>(monitor, disk, 1024);
    while (coarse->parts < 100000) {
        auto fine = std::make_shared<const RadialMass>(monitor, disk, 2 * coarse->parts);
        double error = 0;
        for (std::size_t i = 0; i <= fine->parts; ++i)
            error =
                std::max(error, std::abs(coarse->at(static_cast<double>(i) * fine->width) - fine->mass[i]));
        if (error <= 1e-10 * fine->mass.back()) return fine;
        coarse = std::move(fine);
    }
    return nullptr;
}

std::function<Vec3(Vec3)> affine(const ConvexCurve& source, const ConvexCurve& target) {
    const Covariance a = transport_of_covariances(source.covariance(), target.covariance());
    return [a, from = source.centre(), to = target.centre()](Vec3 xi) {
        const Vec3 d = xi - from;
        return to + Vec3{a.xx * d.x + a.xy * d.y, a.xy * d.x + a.yy * d.y, 0};
    };
}

std::optional<std::function<Vec3(Vec3)>> radial(const ConvexCurve& source, const ConvexCurve& target,
                                                const TransportDensities& densities) {
    const auto from = radial_mass(densities.source, source), to = radial_mass(densities.target, target);
    if (!from || !to) return std::nullopt;
    return [from, to, c = source.centre(), image = target.centre()](Vec3 xi) {
        const Vec3 d = xi - c;
        const double r = norm(d);
        if (r == 0) return image;
        const double part =
            from->at(std::min(r, from->width * static_cast<double>(from->parts))) / from->mass.back();
        return image + (to->radius(part * to->mass.back()) / r) * d;
    };
}

} // namespace

std::optional<std::function<Vec3(Vec3)>> exact_transport(const ConvexCurve& source, const ConvexCurve& target,
                                                         const TransportDensities& densities) {
    if (!source.is_ellipse() || !target.is_ellipse()) return std::nullopt;
    const Symmetry of_source = symmetry_of(densities.source, source),
                   of_target = symmetry_of(densities.target, target);
    if (of_source == Symmetry::constant && of_target == Symmetry::constant) return affine(source, target);
    if (of_source == Symmetry::none || of_target == Symmetry::none) return std::nullopt;
    if (!is_disk(source) || !is_disk(target)) return std::nullopt;
    return radial(source, target, densities);
}

} // namespace gaspard
