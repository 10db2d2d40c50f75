#include "core/method/monge_ampere.hpp"

#include "core/method/power_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gaspard {

IterateShape MongeAmpereEquation::shape() const {
    constexpr double not_elliptic = 1e4; // condition number reported if lambda_min <= 0
    const Ellipticity of = ellipticity();
    return {.admissibility = of.convexity,
            .stable_step = gaspard::stable_step(of),
            .condition = of.slowest > 0 ? of.fastest / of.slowest : not_elliptic};
}

ProblemData MongeAmpereEquation::continued(const ProblemData& data, double t) const {
    ProblemData part = data;
    part.monitor = std::make_shared<PowerMonitor>(data.monitor, t);
    return part;
}

std::string MongeAmpereEquation::name_of_continued(double t) const {
    char text[32];
    std::snprintf(text, sizeof text, "m^%.3g", t);
    return text;
}

double stable_step(const Ellipticity& ellipticity) {
    constexpr double shortened = 0.98; // lambda_max is taken at vertices only and may be underestimated
    constexpr double careful = 0.1;    // if lambda_max <= 0, there is no stability bound
    const double unit = ellipticity.theta > 0 ? ellipticity.theta : 1;
    if (!(ellipticity.fastest > 0)) return careful / unit;
    return std::min(longest_step / unit,
                    shortened * 2 / (ellipticity.fastest + std::max(0.0, ellipticity.slowest)));
}

double preconditioner_scale(double monitor) { return 1 / std::pow(monitor, 0.2); }

} // namespace gaspard
