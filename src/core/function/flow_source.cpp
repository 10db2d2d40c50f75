// The source whose function is computed: q of a flow at time t. A clock moves the row t.
#include "core/function/flow_source.hpp"

#include "core/base/check.hpp"
#include "core/flow/flow_history.hpp"
#include "core/flow/flow_starts.hpp"
#include "core/function/field_function.hpp"

#include <string>
#include <utility>

namespace gaspard {

namespace {

ParameterRow seed_row(const char* help) {
    return {.key = "seed",
            .label = "Seed",
            .kind = ParameterKind::integer,
            .minimum = 0,
            .maximum = 1e9,
            .slider = SliderRange{1, 100},
            .default_value = std::int64_t{1},
            .help = help,
            .role = ParameterRole::seed};
}

ParameterRow radius_row(double usual) {
    return {.key = "radius",
            .label = "Radius",
            .symbol = "r",
            .minimum = 0.01,
            .maximum = 0.3,
            .scale = ParameterScale::logarithmic,
            .default_value = usual,
            .help = "where the vorticity of a vortex has fallen to 1/e; a few cells of the flow",
            .of_all_times = true};
}

std::vector<Vortex> start_vortices(const Values& values) {
    if (values.text("start") == "vortices")
        return scattered_vortices(static_cast<std::size_t>(values.integer("count")),
                                  static_cast<std::uint64_t>(values.integer("seed")));
    const double half = values.real("distance") / 2;
    return {{{0.5 - half, 0.5}, 1}, {{0.5 + half, 0.5}, 1}};
}

/// q at the start, at n x n nodes.
std::vector<double> start_values(std::size_t n, const Values& values) {
    std::vector<double> q = values.text("start") == "noise"
                                ? noise_values(n, static_cast<std::uint64_t>(values.integer("seed")))
                                : vortex_values(n, start_vortices(values), values.real("radius"));
    for (double& value : q) value *= values.real("strength");
    return q;
}

/// All that the flow depends on but the time.
std::string name_of_flow(const Values& values, const Space& space) {
    std::string name = "flow";
    for (const auto& rows : {flow_rows(space), further_flow_rows(values, space)})
        for (const ParameterRow& row : rows)
            if (row.role != ParameterRole::time)
                name += ' ' + row.key + '=' + format_value(values.at(row.key));
    return name;
}

std::shared_ptr<const Checkpoints> history_of(const Values& values, const DataContext& context) {
    const std::function<std::shared_ptr<const Checkpoints>()> make = [&] {
        const auto n = static_cast<std::size_t>(values.integer("cells"));
        return flow_history({.cells = n, .froude = values.real("froude")}, start_values(n, values));
    };
    if (!context.files) return make();
    return context.files->get<Checkpoints>("", name_of_flow(values, context.space), make,
                                           [](const Checkpoints& states) { return states.budget(); });
}

} // namespace

std::vector<ParameterRow> flow_rows(const Space&) {
    return {{.key = "t",
             .label = "Time",
             .symbol = "t",
             .minimum = 0,
             .maximum = 1e5,
             .slider = SliderRange{0, 20},
             .default_value = 0.0,
             .help = "of the flow; the clock sets it while time passes",
             .role = ParameterRole::time},
            {.key = "start",
             .label = "Start",
             .kind = ParameterKind::choice,
             .default_value = std::string("vortices"),
             .choices = {"vortices", "merging", "noise"},
             .help = "at time 0: vortices of both signs, two of one sign that merge, or noise",
             .role = ParameterRole::defines_rows},
            {.key = "strength",
             .label = "Strength",
             .minimum = 1e-3,
             .maximum = 1e3,
             .scale = ParameterScale::logarithmic,
             .slider = SliderRange{0.1, 100},
             .default_value = 20.0,
             .help = "largest vorticity at the start; a vortex turns once in 4π / strength",
             .of_all_times = true},
            {.key = "cells",
             .label = "Cells of the flow",
             .symbol = "n",
             .kind = ParameterKind::integer,
             .minimum = 8,
             .maximum = 512,
             .slider = SliderRange{32, 256},
             .default_value = std::int64_t{100},
             .help = "squares along a side, on which the flow is computed",
             .detail = true},
            {.key = "froude",
             .label = "Froude number",
             .symbol = "Fr",
             .minimum = 0,
             .maximum = 1e4,
             .slider = SliderRange{0, 100},
             .default_value = 1.0,
             .help = "larger: vortices reach less far",
             .of_all_times = true,
             .detail = true}};
}

std::vector<ParameterRow> further_flow_rows(const Values& values, const Space&) {
    const std::string& start = values.text("start");
    if (start == "noise") return {seed_row("of the noise")};
    if (start == "vortices")
        return {{.key = "count",
                 .label = "Vortices",
                 .kind = ParameterKind::integer,
                 .minimum = 1,
                 .maximum = 40,
                 .slider = SliderRange{1, 12},
                 .default_value = std::int64_t{6},
                 .help = "number of vortices at the start"},
                radius_row(0.06),
                seed_row("of the places and strengths of the vortices")};
    return {{.key = "distance",
             .label = "Distance",
             .minimum = 0.02,
             .maximum = 0.5,
             .default_value = 0.2,
             .help = "of the two vortices; they merge at once if it is below three radii",
             .of_all_times = true},
            radius_row(0.08)};
}

FieldData flow_field(const Values& values, const DataContext& context) {
    const auto report = [&](double done) {
        if (context.progress) context.progress(done, "Computing the flow");
    };
    const auto n = static_cast<std::size_t>(values.integer("cells"));
    GridData data{Coordinates::cartesian, {}, {}};
    data.values = history_of(values, context)->at(values.real("t"), report, context.stop);
    GASPARD_CHECK(data.values.size() == n * n);
    for (std::size_t i = 0; i < n; ++i)
        data.axes[0].push_back(static_cast<double>(i) / static_cast<double>(n));
    data.axes[1] = data.axes[0];
    return {"q", {}, std::move(data)};
}

SourceType flow_source() {
    return {.name = "flow",
            .label = "Flow",
            .help = "the potential vorticity q of a quasi-geostrophic flow at time t",
            .rows = flow_rows,
            .make =
                [](const Values& values, const DataContext& context) {
                    return field_function(flow_field(values, context), {}, context);
                },
            .further_rows = further_flow_rows,
            .solids = false,
            .spaces = {SpaceKind::periodic_square}};
}

} // namespace gaspard
