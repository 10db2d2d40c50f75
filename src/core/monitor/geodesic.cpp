#include "core/monitor/geodesic.hpp"

#include <cmath>

namespace gaspard {

double SechProfile::slope(double d) const {
    const double t = sharpness * (d * d - radius * radius);
    return -4 * amplitude * sharpness * d * std::tanh(t) * sech_squared(t);
}

void SechProfile::check() const { check_amplitude(amplitude, -1); }

std::vector<ParameterRow> place_rows(const std::string& prefix, const std::string& what, double latitude,
                                     double longitude) {
    return {{.key = prefix + "_latitude",
             .label = what + " latitude",
             .unit = "°",
             .minimum = -90,
             .maximum = 90,
             .default_value = latitude,
             .help = "north is positive",
             .role = ParameterRole::latitude,
             .point = prefix},
            {.key = prefix + "_longitude",
             .label = what + " longitude",
             .unit = "°",
             .minimum = -180,
             .maximum = 360,
             .default_value = longitude,
             .help = "east is positive",
             .role = ParameterRole::longitude,
             .point = prefix}};
}

Vec3 place_of(const Values& values, const std::string& prefix) {
    return at_latitude_longitude(values.real(prefix + "_latitude"), values.real(prefix + "_longitude"));
}

} // namespace gaspard
