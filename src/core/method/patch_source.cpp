#include "core/method/patch_source.hpp"

#include <algorithm>

namespace gaspard {

namespace {

// J(xi) / J(Psi) is 1 / (the derivative of Psi across the edge) at an edge that is one point, and likewise at
// a corner where J = 0, since Psi keeps edges and corners. The weak boundary condition of the standard form
// keeps them up to an error only, so on coarse meshes a point near such an edge may come arbitrarily close to
// it: this bounds the ratio.
constexpr double least_area = 1e-3; // J(Psi), relative to J(xi)

} // namespace

PatchSource::PatchSource(const Monitor& monitor, const PatchMap& map, const SplineLine& line,
                         std::span<const double> areas)
    : monitor_(monitor), map_(map), areas_(areas), row_(line.points.size()) {
    const std::size_t n = line.points.size();
    Points xi(n);
    std::vector<double> rho(n);
    xi.x = line.points;
    double total = 0; // the integral of J
    for (std::size_t j = 0; j < n; ++j) {
        xi.y.assign(n, line.points[j]);
        monitor_.values(place(xi), rho);
        double sum = 0, area = 0;
        if (areas_.empty())
            for (std::size_t i = 0; i < n; ++i) sum += line.weights[i] * rho[i];
        else
            for (std::size_t i = 0; i < n; ++i) {
                const double weight = line.weights[i] * areas_[j * n + i];
                sum += weight * rho[i];
                area += weight;
            }
        sigma_ += line.weights[j] * sum;
        total += line.weights[j] * area;
    }
    if (!areas_.empty()) sigma_ /= total;
}

const Points& PatchSource::place(const Points& psi) const {
    if (map_.is_identity()) return psi;
    map_.points(psi, x_);
    return x_;
}

void PatchSource::values(std::size_t y, const Points& psi, std::span<double> f) const {
    if (areas_.empty()) {
        monitor_.values(place(psi), f);
        for (double& value : f) value = sigma_ / value;
        return;
    }
    area_.resize(psi.size());
    map_.places(psi, x_, area_);
    monitor_.values(x_, f);
    const std::span<const double> before = areas_of(y, f.size());
    for (std::size_t i = 0; i < f.size(); ++i)
        f[i] = sigma_ * before[i] / (f[i] * std::max(area_[i], least_area * before[i]));
}

void PatchSource::monitor_values(std::span<const double> f, std::span<double> rho) const {
    if (!areas_.empty()) return monitor_.values(x_, rho);
    for (std::size_t i = 0; i < f.size(); ++i) rho[i] = sigma_ / f[i];
}

void PatchSource::gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const {
    values(y, psi, f);
    const Points& x = map_.is_identity() ? psi : x_;
    monitor_.gradients(x, slope_);
    map_.tangents(psi, first_, second_);
    gradient.resize(psi.size());
    if (areas_.empty()) {
        for (std::size_t i = 0; i < psi.size(); ++i) { // d(sigma / rho) = -f^2 / sigma drho
            const double factor = -f[i] * f[i] / sigma_;
            gradient.set(i, {factor * dot(slope_[i], first_[i]), factor * dot(slope_[i], second_[i]), 0});
        }
        return;
    }
    // df = -f (drho / rho + dJ / J), J = J(Psi)
    map_.area_gradients(psi, area_, gradient);
    const std::span<const double> before = areas_of(y, f.size());
    for (std::size_t i = 0; i < psi.size(); ++i) {
        const bool bounded = !(area_[i] > least_area * before[i]);
        const double area = bounded ? least_area * before[i] : area_[i];
        const Vec3 turn = bounded ? Vec3{} : (-f[i] / area) * gradient[i];
        const double factor = -f[i] * f[i] * area / (sigma_ * before[i]);
        gradient.set(i,
                     Vec3{factor * dot(slope_[i], first_[i]), factor * dot(slope_[i], second_[i]), 0} + turn);
    }
}

std::vector<double> area_elements(const PatchMap& map, const SplineLine& line) {
    const std::size_t n = line.points.size();
    std::vector<double> areas(n * n);
    Points xi(n), x;
    xi.x = line.points;
    for (std::size_t j = 0; j < n; ++j) {
        xi.y.assign(n, line.points[j]);
        map.places(xi, x, std::span(areas).subspan(j * n, n));
    }
    return areas;
}

} // namespace gaspard
