#include "core/monitor/radial.hpp"

#include "core/base/check.hpp"
#include "core/base/short_number.hpp"
#include "core/monitor/geodesic.hpp"

#include <cmath>

namespace gaspard {

void SechMonitor::values(const Points& x, std::span<double> values) const {
    GASPARD_CHECK(values.size() == x.size());
    const double a = p_.amplitude, b = p_.sharpness, r = p_.radius_squared;
    const auto [cx, cy, cz] = p_.centre;
    const double *px = x.x.data(), *py = x.y.data(), *pz = x.z.data();
    double* __restrict out = values.data();
    const double wrap = space_.kind == SpaceKind::periodic_square ? 1 : 0;
    for (std::size_t i = 0; i < values.size(); ++i) { // displacement(), inlined by hand for speed
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

void SechMonitor::check() const { check_amplitude(p_.amplitude, -1); }

void check_amplitude(double amplitude, double least) {
    if (!std::isfinite(amplitude))
        throw InputError("monitor.amplitude = " + exact_number(amplitude) +
                         " is invalid; it must be finite and greater than " + exact_number(least));
    if (amplitude <= least)
        throw InputError("monitor.amplitude = " + exact_number(amplitude) +
                         " makes the monitor zero or negative; it must be greater than " +
                         exact_number(least));
}

ParameterRow amplitude_row(double maximum, double value, const std::string& where) {
    return {.key = "amplitude",
            .label = "Amplitude",
            .symbol = "A",
            .minimum = -0.99,
            .maximum = maximum,
            .scale = ParameterScale::logarithmic,
            .default_value = value,
            .help = "m = 1 + A " + where + "; must exceed -1"};
}

ParameterRow sharpness_row(double value, const std::string& half_height, const std::string& unit) {
    return {.key = "sharpness",
            .label = "Sharpness",
            .symbol = "B",
            .unit = unit,
            .minimum = 1,
            .maximum = 2000,
            .scale = ParameterScale::logarithmic,
            .default_value = value,
            .help = "larger is narrower; the half-width at half maximum is about " + half_height};
}

std::vector<ParameterRow> center_rows(const Space& space) {
    if (space.kind == SpaceKind::sphere) return place_rows("center", "Centre", 30, 0);
    const auto row = [&](const char* key, const char* label, const char* symbol, ParameterRole role) {
        return ParameterRow{.key = key,
                            .label = label,
                            .symbol = symbol,
                            .minimum = 0,
                            .maximum = 1,
                            .default_value = 0.5,
                            .help = "position of the centre",
                            .role = role,
                            .point = "center",
                            .periodic = space.kind == SpaceKind::periodic_square};
    };
    std::vector<ParameterRow> rows = {row("center_x", "Centre x", "c₁", ParameterRole::x),
                                      row("center_y", "Centre y", "c₂", ParameterRole::y)};
    if (space.dimension == 3) {
        rows.push_back(row("center_z", "Centre z", "c₃", ParameterRole::z));
        rows.back().minimum = -10, rows.back().maximum = 10;
        rows.back().default_value = space.solid ? 0.5 : 0.0; // in a cube the middle
    }
    return rows;
}

std::string distance_formula(const Space& space, const std::string& point) {
    if (space.kind == SpaceKind::sphere) return "dist(" + point + "_latitude, " + point + "_longitude)";
    const std::string third = space.dimension == 3 ? ", " + point + "_z" : "";
    return "dist(" + point + "_x, " + point + "_y" + third + ")";
}

std::shared_ptr<const Monitor> make_sech_monitor(const Values& values, double radius, const Space& space) {
    if (space.kind == SpaceKind::sphere)
        return std::make_shared<GeodesicMonitor<SechProfile>>(
            1.0, SechProfile{values.real("amplitude"), values.real("sharpness"), radius},
            std::vector{place_of(values, "center")});
    return std::make_shared<SechMonitor>(
        SechMonitor::Parameters{values.real("amplitude"),
                                values.real("sharpness"),
                                radius * radius,
                                {values.real("center_x"), values.real("center_y"),
                                 values.has("center_z") ? values.real("center_z") : 0}},
        space);
}

} // namespace gaspard
