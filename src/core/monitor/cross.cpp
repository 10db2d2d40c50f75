// Two intersecting bands on the sphere, McRae, Cotter, Budd (5.11), each along the great circle at distance
// pi/2 from its pole p1 or p2.
#include "core/monitor/geodesic.hpp"
#include "core/monitor/radial.hpp"

#include <numbers>

namespace gaspard {

MonitorType cross_monitor() {
    return {.name = "cross",
            .label = "Cross",
            .help = "small cells along two great circles",
            .equation = "m(x) = 1 + A sech²( B (|x - p₁|² - (π/2)²) ) + A sech²( B (|x - p₂|² - (π/2)²) )",
            .spaces = {SpaceKind::sphere},
            .rows =
                [](const Space&) {
                    std::vector<ParameterRow> rows = {amplitude_row(1000, 10.0, "on each band"),
                                                      sharpness_row(5.0, "0.28 / B", "1/radian²")};
                    rows.front().minimum = -0.49; // m = 1 + 2 A at the intersections
                    rows.front().help =
                        "m = 1 + A on each band and 1 + 2 A at the intersections; must exceed -1/2";
                    for (auto& row : place_rows("pole1", "Pole 1", 30, 0)) rows.push_back(std::move(row));
                    for (auto& row : place_rows("pole2", "Pole 2", 30, 180)) rows.push_back(std::move(row));
                    return rows;
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                const SechProfile band{v.real("amplitude"), v.real("sharpness"), std::numbers::pi / 2};
                return std::make_shared<GeodesicMonitor<SechProfile>>(
                    1.0, band, std::vector{place_of(v, "pole1"), place_of(v, "pole2")});
            },
            .formula =
                [](const Space& space) {
                    const auto band = [&](const char* pole) {
                        return " + amplitude*sech(sharpness*(" + distance_formula(space, pole) +
                               "^2 - (pi/2)^2))^2";
                    };
                    return "1" + band("pole1") + band("pole2");
                }};
}

} // namespace gaspard
