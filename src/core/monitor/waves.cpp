// A spiral and waves, Bahari et al. (2024): examples 5.4 (the paper prints 20 r instead of 20 r^2), 7.3, 7.8
// and 7.7 (sin(2 pi/3) is a constant, as printed).
#include "core/base/cosine.hpp"
#include "core/base/exponential.hpp"
#include "core/monitor/formula.hpp"
#include "core/monitor/placement.hpp"
#include "core/monitor/radial.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace gaspard {

namespace {

using std::numbers::pi;

/// m = 1 + A / (1 + t^2),   t = B r cos(angle - w) = B (dx cos w + dy sin w),   w = k r^2,
/// with (r, angle) the polar coordinates of (dx, dy) = x - c.
struct Spiral {
    double amplitude, sharpness, winding;
    Vec3 centre;

    double value(Vec3 x) const {
        const double dx = x.x - centre.x, dy = x.y - centre.y, w = winding * (dx * dx + dy * dy);
        const double t = sharpness * (dx * std::cos(w) + dy * std::sin(w));
        return 1 + amplitude / (1 + t * t);
    }
    Vec3 gradient(Vec3 x) const {
        const double dx = x.x - centre.x, dy = x.y - centre.y, w = winding * (dx * dx + dy * dy);
        const double c = std::cos(w), s = std::sin(w);
        const double t = sharpness * (dx * c + dy * s), dw = sharpness * (dy * c - dx * s);
        const double factor = -2 * amplitude * t / ((1 + t * t) * (1 + t * t));
        return {factor * (sharpness * c + dw * 2 * winding * dx),
                factor * (sharpness * s + dw * 2 * winding * dy), 0};
    }
    void check() const { check_amplitude(amplitude, -1); }
};

struct CosineWaves {
    double frequency; ///< in 1 / length
    Vec3 centre;

    double value(Vec3 x) const { return 1 / (2 + cosine_of_turns(frequency * norm(x - centre))); }
    Vec3 gradient(Vec3 x) const {
        const Vec3 d = x - centre;
        const double k = 2 * pi * frequency, r = norm(d), m = value(x);
        if (r == 0) return {};
        return (m * m * k * std::sin(k * r) / r) * d;
    }
    void check() const {}
};

struct SineWaves {
    double amplitude, sharpness;

    double value(Vec3 x) const {
        const double s = 0.25 * std::sin(2 * pi * x.x), upper = x.y - 0.5 - factor() * s,
                     lower = x.y - 0.25 - s;
        return 1 + amplitude * (exponential(-sharpness * std::abs(upper)) +
                                exponential(-sharpness * std::abs(lower)));
    }
    Vec3 gradient(Vec3 x) const {
        const double s = 0.25 * std::sin(2 * pi * x.x), slope = 0.5 * pi * std::cos(2 * pi * x.x);
        const auto part = [&](double t, double steepness) {
            const double d = (t > 0   ? -1
                              : t < 0 ? 1
                                      : 0) *
                             amplitude * sharpness * exponential(-sharpness * std::abs(t));
            return d * Vec3{-steepness * slope, 1, 0};
        };
        return part(x.y - 0.5 - factor() * s, factor()) + part(x.y - 0.25 - s, 1);
    }
    void check() const { check_amplitude(amplitude, -0.5); }

  private:
    static double factor() { return std::sqrt(3.0) / 2; } // sin(2 pi / 3)
};

} // namespace

MonitorType spiral_monitor() {
    return {.name = "spiral",
            .label = "Spiral",
            .help = "small cells along the arms of a spiral",
            .equation = "m(x) = 1 + A / (1 + (B r cos(angle - k r²))²), r, angle relative to c",
            .figure = MonitorFigure::unit_square,
            .spaces = {SpaceKind::euclidean},
            .solids = false,
            .rows =
                [](const Space&) {
                    std::vector<ParameterRow> rows = {
                        amplitude_row(1000, 9, "on the arms"),
                        sharpness_row(10, "1/B", "1/length"),
                        {.key = "winding",
                         .label = "Winding",
                         .symbol = "k",
                         .unit = "1/length²",
                         .minimum = 0,
                         .maximum = 200,
                         .default_value = 20.0,
                         .help = "larger winds the arms more tightly; 0: straight"}};
                    for (auto& row : center_in_space_rows({0.7, 0.5, 0}))
                        if (row.key != "center_z") rows.push_back(std::move(row));
                    return rows;
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                return std::make_shared<FormulaMonitor<Spiral>>(
                    Spiral{v.real("amplitude"),
                           v.real("sharpness"),
                           v.real("winding"),
                           {v.real("center_x"), v.real("center_y"), 0}});
            },
            .formula =
                [](const Space&) {
                    const std::string angle = "winding*dist(center_x, center_y)^2";
                    return "1 + amplitude/(1 + (sharpness*((x - center_x)*cos(" + angle +
                           ") + (y - center_y)*sin(" + angle + ")))^2)";
                }};
}

MonitorType cosine_waves_monitor() {
    return {.name = "cosine-waves",
            .label = "Cosine waves",
            .help = "rings around a point; max m / min m = 3",
            .equation = "m(x) = 1 / (2 + cos(2 π k |x - c|))",
            .figure = MonitorFigure::unit_square,
            .spaces = {SpaceKind::euclidean},
            .rows =
                [](const Space& space) {
                    std::vector<ParameterRow> rows = {{.key = "frequency",
                                                       .label = "Frequency",
                                                       .symbol = "k",
                                                       .unit = "1/length",
                                                       .minimum = 0.1,
                                                       .maximum = 20,
                                                       .scale = ParameterScale::logarithmic,
                                                       .default_value = 4.0,
                                                       .help = "number of rings per unit length"}};
                    for (auto& row : center_in_space_rows({0.5, 0.5, space.solid ? 0.5 : 0}))
                        rows.push_back(std::move(row));
                    return rows;
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                return std::make_shared<FormulaMonitor<CosineWaves>>(
                    CosineWaves{v.real("frequency"), center_in_space(v)});
            },
            .formula =
                [](const Space&) {
                    return std::string("1/(2 + cos(2*pi*frequency*dist(center_x, center_y, center_z)))");
                }};
}

MonitorType sine_waves_monitor() {
    return {.name = "sine-waves",
            .label = "Sine waves",
            .help = "small cells along two sine curves, where m has a crease",
            .equation = "m(x) = 1 + A exp( -B |y - 1/2 - sin(2 π x) sin(2 π/3) / 4| ) "
                        "+ A exp( -B |y - 1/4 - sin(2 π x) / 4| )",
            .figure = MonitorFigure::unit_square,
            .spaces = {SpaceKind::euclidean},
            .solids = false,
            .rows =
                [](const Space&) {
                    ParameterRow amplitude = amplitude_row(1000, 5, "on the waves");
                    amplitude.minimum = 0;
                    return std::vector<ParameterRow>{amplitude, sharpness_row(50, "0.7 / B", "1/length")};
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                return std::make_shared<FormulaMonitor<SineWaves>>(
                    SineWaves{v.real("amplitude"), v.real("sharpness")});
            },
            .formula =
                [](const Space& space) {
                    const Placement at = placement_of(MonitorFigure::unit_square, space);
                    const bool here = at.scale == 1 && at.origin.x == 0;
                    const std::string side = format_number(at.scale), left = format_number(at.origin.x);
                    const std::string sine =
                        here ? "sin(2*pi*x)" : side + "*sin(2*pi*(x - " + left + ")/" + side + ")";
                    const auto wave = [&](double height, const std::string& factor) {
                        return " + amplitude*exp(-sharpness*abs(y - " +
                               format_number(at.origin.y + at.scale * height) + " - " + sine + factor +
                               "/4))";
                    };
                    return "1" + wave(0.5, "*sin(2*pi/3)") + wave(0.25, "");
                }};
}

} // namespace gaspard
