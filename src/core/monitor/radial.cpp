#include "core/monitor/radial.hpp"

#include "core/base/check.hpp"
#include "core/base/exponential.hpp"

#include <cmath>

namespace gaspard {

namespace {

// 1 / cosh^2 without overflow: for large |t| it is 0 to double precision.
double sech_squared(double t) {
    const double e = exponential(-2 * std::abs(t));
    return 4 * e / ((1 + e) * (1 + e));
}

} // namespace

void SechMonitor::values(const Points& x, std::span<double> values) const {
    GASPARD_CHECK(values.size() == x.size());
    const double a = p_.amplitude, b = p_.sharpness, r = p_.radius_squared;
    const auto [cx, cy, cz] = p_.centre;
    const double *px = x.x.data(), *py = x.y.data(), *pz = x.z.data();
    double* __restrict out = values.data();
    const double wrap = space_.kind == SpaceKind::periodic_square ? 1 : 0;
    for (std::size_t i = 0; i < values.size(); ++i) { // displacement(), spelt out: this is a hot loop
        double dx = px[i] - cx, dy = py[i] - cy;
        const double dz = pz[i] - cz;
        dx -= wrap * nearest_whole(dx);
        dy -= wrap * nearest_whole(dy);
        out[i] = 1 + a * sech_squared(b * (dx * dx + dy * dy + dz * dz - r));
    }
}

void SechMonitor::gradients(const Points& x, Points& gradients) const {
    gradients.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 d = displacement(space_, p_.centre, x[i]);
        const double t = p_.sharpness * (dot(d, d) - p_.radius_squared);
        // d/dt sech^2 t = -2 tanh t sech^2 t;  grad t = 2 B d
        gradients.set(i, (-4 * p_.amplitude * p_.sharpness * std::tanh(t) * sech_squared(t)) * d);
    }
}

void SechMonitor::check() const {
    if (!std::isfinite(p_.amplitude))
        throw InputError("monitor.amplitude = " + format_number(p_.amplitude) +
                         " is not a number that a monitor can have; it must be finite and greater than -1");
    if (1 + p_.amplitude <= 0)
        throw InputError("monitor.amplitude = " + format_number(p_.amplitude) +
                         " makes the monitor zero or negative; it must be greater than -1");
}

ParameterRow amplitude_row(double maximum, double value, const std::string& where) {
    return {.key = "amplitude",
            .label = "Amplitude",
            .symbol = "A",
            .minimum = -0.99,
            .maximum = maximum,
            .scale = ParameterScale::logarithmic,
            .default_value = value,
            .help = "how much denser the mesh is " + where + "; the monitor would vanish at -1"};
}

ParameterRow sharpness_row(double value, const std::string& half_height) {
    return {.key = "sharpness",
            .label = "Sharpness",
            .symbol = "B",
            .unit = "1/length^2",
            .minimum = 1,
            .maximum = 2000,
            .scale = ParameterScale::logarithmic,
            .default_value = value,
            .help = "larger is narrower: half the height at a distance of about " + half_height};
}

ParameterRow center_row(const std::string& key, const std::string& label, const std::string& symbol) {
    return {.key = key,
            .label = label,
            .symbol = symbol,
            .minimum = 0,
            .maximum = 1,
            .default_value = 0.5,
            .help = "where the feature stands; the square is [0, 1] x [0, 1]"};
}

std::shared_ptr<const Monitor> make_sech_monitor(const Values& values, double radius, const Space& space) {
    return std::make_shared<SechMonitor>(
        SechMonitor::Parameters{values.real("amplitude"),
                                values.real("sharpness"),
                                radius * radius,
                                {values.real("center_x"), values.real("center_y"), 0}},
        space);
}

} // namespace gaspard
