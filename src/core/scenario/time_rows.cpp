#include "core/scenario/time_rows.hpp"

#include <algorithm>
#include <string>

namespace gaspard {

namespace {

std::vector<ParameterRow> clock_rows() {
    constexpr double most = 1e9;
    return {{.key = "start",
             .label = "Start",
             .symbol = "t₀",
             .minimum = -most,
             .maximum = most,
             .slider = SliderRange{0, 10},
             .default_value = 0.0,
             .help = "the time of the first mesh"},
            {.key = "end",
             .label = "End",
             .symbol = "T",
             .minimum = -most,
             .maximum = most,
             .slider = SliderRange{0, 10},
             .default_value = 0.0,
             .help = "the time of the last mesh; nothing moves unless it is later than the start"},
            {.key = "step",
             .label = "Time step",
             .symbol = "Δt",
             .minimum = 1e-9,
             .maximum = most,
             .scale = ParameterScale::logarithmic,
             .slider = SliderRange{1e-3, 1},
             .default_value = 0.02,
             .help = "from one mesh to the next; the last step may be shorter"}};
}

std::vector<ParameterRow> following_rows() {
    return {
        {.key = "speed",
         .label = "Speed",
         .unit = "units of t per second",
         .minimum = 0,
         .maximum = 1e6,
         .slider = SliderRange{0, 5},
         .default_value = 0.0,
         .help = "of the time in the window; steps that would come too late are left out; 0: every step, as "
                 "fast as the mesh follows",
         .detail = true},
        {.key = "rule",
         .label = "Rule",
         .kind = ParameterKind::choice,
         .default_value = std::string(time_rule::equidistribution),
         .choices = {std::string(time_rule::equidistribution), std::string(time_rule::tolerance),
                     std::string(time_rule::iterations), std::string(time_rule::relaxation)},
         .help = "when a time step is solved: equidistribution within time.factor of the solved mesh's; "
                 "residual below time.tolerance; after time.iterations; relaxation: one iteration, with the "
                 "time scale time.tau"},
        {.key = "factor",
         .label = "Factor",
         .minimum = 1.001,
         .maximum = 10,
         .scale = ParameterScale::logarithmic,
         .slider = SliderRange{1.01, 2},
         .default_value = 1.05,
         .help = "rule equidistribution: at most so many times that of the mesh solved to method.tolerance",
         .detail = true},
        {.key = "tolerance",
         .label = "Tolerance per step",
         .kind = ParameterKind::real_or_auto,
         .minimum = 1e-14,
         .maximum = 1,
         .scale = ParameterScale::logarithmic,
         .default_value = std::string("auto"),
         .help = "rule tolerance: a time step is solved when the residual is below; auto: method.tolerance",
         .detail = true},
        {.key = "iterations",
         .label = "Iterations per step",
         .kind = ParameterKind::integer,
         .minimum = 1,
         .maximum = 10000,
         .scale = ParameterScale::logarithmic,
         .default_value = std::int64_t{100},
         .help = "rule iterations: that many; rules equidistribution and tolerance: at most",
         .detail = true},
        {.key = "tau",
         .label = "Time scale",
         .symbol = "τ",
         .minimum = 1e-9,
         .maximum = 1e9,
         .scale = ParameterScale::logarithmic,
         .slider = SliderRange{1e-3, 10},
         .default_value = 0.1,
         .help = "rule relaxation: the mesh approaches the solved one as exp(-t / τ)",
         .detail = true},
        {.key = "extrapolation",
         .label = "Extrapolation",
         .kind = ParameterKind::choice,
         .default_value = std::string("auto"),
         .choices = {"auto", "none", "linear", "quadratic"},
         .help = "where a time step begins: at the map before it, or extrapolated from two or three; auto: "
                 "whichever would have been best for the last step",
         .detail = true},
        {.key = "path",
         .label = "Path",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "places of the monitor's point in time, joined by a smooth curve: \"0 0.3 0.5; 1 0.7 0.5\" "
                 "(t x y; on a sphere t latitude longitude)",
         .detail = true}};
}

} // namespace

std::vector<ParameterRow> time_rows(const std::vector<ParameterRow>& monitor) {
    std::vector<ParameterRow> rows = clock_rows();
    for (const ParameterRow& row : monitor) {
        if (row.kind != ParameterKind::real || row.role == ParameterRole::time || row.of_all_times) continue;
        rows.push_back({.key = std::string(moving_prefix) + row.key,
                        .label = row.label + "(t)",
                        .symbol = row.symbol.empty() ? "" : row.symbol + "(t)",
                        .unit = row.unit,
                        .kind = ParameterKind::text,
                        .default_value = std::string(),
                        .help = "monitor." + row.key +
                                " as a formula in t and the monitor's parameters, such as \"" + row.key +
                                " + 0.1*t\"; leave empty to keep it constant",
                        .role = ParameterRole::motion,
                        .detail = true});
    }
    for (ParameterRow& row : following_rows()) rows.push_back(std::move(row));
    return rows;
}

bool has_time(const Values& time) { return time.real("end") > time.real("start"); }

bool has_motion(const Values& time) {
    return !time.text("path").empty() ||
           std::any_of(time.rows().begin(), time.rows().end(), [&](const ParameterRow& row) {
               return row.role == ParameterRole::motion && !time.text(row.key).empty();
           });
}

bool same_time(const Values& a, const Values& b) {
    return std::all_of(a.rows().begin(), a.rows().end(), [&](const ParameterRow& row) {
        return row.key == "speed" ||
               (b.has(row.key) ? a.at(row.key) == b.at(row.key) : is_default(a, row.key));
    });
}

} // namespace gaspard
