// Creased circles, Bahari et al. (2024), examples 5.3, 5.5 and 7.5:
//
//   m(x) = 1 + sum_i A_i exp( -B | |x - c_i|^2 - r_i^2 | )
//
// Smooth circles, examples 5.6 and 7.9 (the paper prints 5 / sech instead of 5 sech^2):
//
//   m(x) = 1 + sum_i A sech^2( B (|x - c_i|^2 - r^2) )
#include "core/base/exponential.hpp"
#include "core/monitor/formula.hpp"
#include "core/monitor/placement.hpp"
#include "core/monitor/radial.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace gaspard {

namespace {

struct Circle {
    double amplitude = 0, radius_squared = 0;
    Vec3 centre;
};

template <std::size_t count>
struct CreasedCircles {
    std::array<Circle, count> circles;
    double sharpness;

    double value(Vec3 x) const {
        double sum = 1;
        for (const Circle& c : circles)
            sum += c.amplitude *
                   exponential(-sharpness * std::abs(dot(x - c.centre, x - c.centre) - c.radius_squared));
        return sum;
    }
    Vec3 gradient(Vec3 x) const {
        Vec3 sum;
        for (const Circle& c : circles) {
            const Vec3 d = x - c.centre;
            const double t = dot(d, d) - c.radius_squared;
            const double side = t > 0 ? 1 : t < 0 ? -1 : 0;
            sum = sum + (-2 * side * sharpness * c.amplitude * exponential(-sharpness * std::abs(t))) * d;
        }
        return sum;
    }
    void check() const {
        for (const Circle& c : circles) check_amplitude(c.amplitude, -1);
    }
};

struct SmoothCircles {
    std::array<Circle, 2> circles;
    double sharpness;

    double value(Vec3 x) const {
        double sum = 1;
        for (const Circle& c : circles) {
            const Vec3 d = x - c.centre;
            sum += c.amplitude * sech_squared(sharpness * (dot(d, d) - c.radius_squared));
        }
        return sum;
    }
    Vec3 gradient(Vec3 x) const {
        Vec3 sum;
        for (const Circle& c : circles) {
            const Vec3 d = x - c.centre;
            const double t = sharpness * (dot(d, d) - c.radius_squared);
            sum = sum + (-4 * c.amplitude * sharpness * std::tanh(t) * sech_squared(t)) * d;
        }
        return sum;
    }
    void check() const {
        for (const Circle& c : circles) check_amplitude(c.amplitude, -1);
    }
};

/// With all three coordinates: on surfaces in space the distance is that in space.
std::string distance_formula(Vec3 from) {
    return "dist(" + format_number(from.x) + ", " + format_number(from.y) + ", " + format_number(from.z) +
           ")";
}

ParameterRow positive_amplitude(double value, const std::string& where) {
    ParameterRow row = amplitude_row(1000, value, where);
    row.minimum = 0; // keeps the sum positive
    return row;
}

ParameterRow creased_sharpness(double value) {
    ParameterRow row = sharpness_row(value, "0.35 / (B r)");
    return row;
}

} // namespace

MonitorType circle_monitor() {
    return {.name = "circle",
            .label = "Circle",
            .help = "small cells along a circle, where m has a crease",
            .equation = "m(x) = 1 + A exp( -B | |x - c|² - r² | )",
            .figure = MonitorFigure::unit_square,
            .spaces = {SpaceKind::euclidean},
            .solids = false,
            .rows =
                [](const Space&) {
                    std::vector<ParameterRow> rows = {amplitude_row(1000, 5, "on the circle"),
                                                      creased_sharpness(50),
                                                      {.key = "radius",
                                                       .label = "Radius",
                                                       .symbol = "r",
                                                       .unit = "length",
                                                       .minimum = 0,
                                                       .maximum = 10,
                                                       .default_value = 0.3,
                                                       .help = "radius of the circle"}};
                    for (auto& row : center_in_space_rows({0.5, 0.5, 0})) rows.push_back(std::move(row));
                    return rows;
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                const double r = v.real("radius");
                return std::make_shared<FormulaMonitor<CreasedCircles<1>>>(CreasedCircles<1>{
                    {Circle{v.real("amplitude"), r * r, center_in_space(v)}}, v.real("sharpness")});
            },
            .formula =
                [](const Space&) {
                    return std::string("1 + amplitude*exp(-sharpness*abs(dist(center_x, center_y, center_z)^2"
                                       " - radius^2))");
                }};
}

MonitorType three_circles_monitor() {
    return {.name = "three-circles",
            .label = "Three circles",
            .help = "a large circle and two small ones in the unit disk, like a head with ears",
            .equation = "m(x) = 1 + Σᵢ A exp( -B | |x - cᵢ|² - rᵢ² | ) + Aₘ exp( -B | |x - cₘ|² - rₘ² | )",
            .figure = MonitorFigure::unit_disk,
            .spaces = {SpaceKind::euclidean},
            .solids = false,
            .rows =
                [](const Space&) {
                    ParameterRow mouth = positive_amplitude(0, "on the mouth");
                    mouth.key = "mouth";
                    mouth.label = "Mouth";
                    mouth.symbol = "Aₘ";
                    return std::vector<ParameterRow>{positive_amplitude(5, "on the circles"),
                                                     creased_sharpness(100), mouth};
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                const double a = v.real("amplitude");
                return std::make_shared<FormulaMonitor<CreasedCircles<4>>>(CreasedCircles<4>{
                    {Circle{a, 0.1, {0.45, 0.4, 0}}, Circle{a, 0.2, {0, 0, 0}},
                     Circle{a, 0.1, {-0.45, 0.4, 0}}, Circle{v.real("mouth"), 0.4, {0, -1.25, 0}}},
                    v.real("sharpness")});
            },
            .formula =
                [](const Space& space) {
                    const Placement at = placement_of(MonitorFigure::unit_disk, space);
                    const auto circle = [&](const std::string& height, double radius_squared, Vec3 centre) {
                        return " + " + height + "*exp(-sharpness*abs(" +
                               distance_formula(at.origin + at.scale * centre) + "^2 - " +
                               format_number(at.scale * at.scale * radius_squared) + "))";
                    };
                    return "1" + circle("amplitude", 0.1, {0.45, 0.4, 0}) +
                           circle("amplitude", 0.2, {0, 0, 0}) + circle("amplitude", 0.1, {-0.45, 0.4, 0}) +
                           circle("mouth", 0.4, {0, -1.25, 0});
                }};
}

MonitorType two_circles_monitor() {
    return {.name = "two-circles",
            .label = "Two circles",
            .help = "small cells along two large circles (spheres in space) that intersect",
            .equation = "m(x) = 1 + Σᵢ A sech²( B (|x - cᵢ|² - r²) ), cᵢ = (±sqrt(3)/2, 1/2, c₃)",
            .figure = MonitorFigure::unit_disk,
            .spaces = {SpaceKind::euclidean},
            .solids = false,
            .rows =
                [](const Space&) {
                    return std::vector<ParameterRow>{positive_amplitude(5, "on the circles"),
                                                     sharpness_row(5, "0.44 / (B r)"),
                                                     {.key = "radius",
                                                      .label = "Radius",
                                                      .symbol = "r",
                                                      .unit = "length",
                                                      .minimum = 0,
                                                      .maximum = 10,
                                                      .default_value = std::numbers::pi / 2,
                                                      .help = "radius of both circles"},
                                                     {.key = "center_z",
                                                      .label = "Centre z",
                                                      .symbol = "c₃",
                                                      .minimum = -10,
                                                      .maximum = 10,
                                                      .default_value = 0.0,
                                                      .help = "z coordinate of both centres, for surfaces in "
                                                              "space; 1/2 on the Möbius strip of the "
                                                              "paper",
                                                      .role = ParameterRole::z,
                                                      .point = "center"}};
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                const double a = v.real("amplitude"), r = v.real("radius"), z = v.real("center_z");
                const double x = std::sqrt(3.0) / 2;
                return std::make_shared<FormulaMonitor<SmoothCircles>>(SmoothCircles{
                    {Circle{a, r * r, {x, 0.5, z}}, Circle{a, r * r, {-x, 0.5, z}}}, v.real("sharpness")});
            },
            .formula =
                [](const Space& space) {
                    const Placement at = placement_of(MonitorFigure::unit_disk, space);
                    const auto circle = [&](double x) {
                        const Vec3 centre = at.origin + at.scale * Vec3{x, 0.5, 0};
                        return " + amplitude*sech(sharpness*(dist(" + format_number(centre.x) + ", " +
                               format_number(centre.y) + ", center_z)^2 - radius^2))^2";
                    };
                    return "1" + circle(std::sqrt(3.0) / 2) + circle(-std::sqrt(3.0) / 2);
                }};
}

} // namespace gaspard
