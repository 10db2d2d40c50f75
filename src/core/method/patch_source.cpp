#include "core/method/patch_source.hpp"

namespace gaspard {

PatchSource::PatchSource(const Monitor& monitor, const PatchMap& map, const SplineLine& line)
    : monitor_(monitor), map_(map) {
    const std::size_t n = line.points.size();
    Points xi(n);
    std::vector<double> rho(n);
    xi.x = line.points;
    for (std::size_t j = 0; j < n; ++j) {
        xi.y.assign(n, line.points[j]);
        monitor_.values(place(xi), rho);
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += line.weights[i] * rho[i];
        sigma_ += line.weights[j] * sum;
    }
}

const Points& PatchSource::place(const Points& psi) const {
    if (map_.is_identity()) return psi;
    map_.points(psi, x_);
    return x_;
}

void PatchSource::values(std::size_t, const Points& psi, std::span<double> f) const {
    monitor_.values(place(psi), f);
    for (double& value : f) value = sigma_ / value;
}

void PatchSource::gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const {
    values(y, psi, f);
    monitor_.gradients(place(psi), slope_);
    map_.tangents(psi, first_, second_);
    gradient.resize(psi.size());
    for (std::size_t i = 0; i < psi.size(); ++i) { // d(sigma / rho) = -f^2 / sigma drho
        const double factor = -f[i] * f[i] / sigma_;
        gradient.set(i, {factor * dot(slope_[i], first_[i]), factor * dot(slope_[i], second_[i]), 0});
    }
}

} // namespace gaspard
