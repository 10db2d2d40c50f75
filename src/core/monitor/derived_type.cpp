// The type "derived": u from a source, whose keys begin with "u.", and the stages that make a monitor of it.
#include "core/base/growing_values.hpp"
#include "core/function/source.hpp"
#include "core/monitor/derived.hpp"
#include "core/monitor/derived_fields.hpp"

#include <string_view>
#include <utility>

namespace gaspard {

namespace {

ParameterRow boolean(const char* key, const char* label, const char* help) {
    return {.key = key, .label = label, .kind = ParameterKind::boolean, .default_value = true, .help = help};
}

ParameterRow kind_row() {
    return {.key = "kind",
            .label = "Indicator",
            .kind = ParameterKind::choice,
            .default_value = std::string("arc-length"),
            .choices = {"arc-length", "curvature", "gradient", "magnitude", "band"},
            .help = "what of u the mesh resolves: slopes, curvature, |grad u|, |u|, or a level u = c",
            .role = ParameterRole::defines_rows};
}

ParameterRow alpha_row(const std::string& kind) {
    ParameterRow row{.key = "alpha",
                     .label = "Intensity",
                     .symbol = "α",
                     .minimum = 1e-4,
                     .maximum = 1e6,
                     .scale = ParameterScale::logarithmic,
                     .default_value = 1.0};
    row.help = kind == "arc-length"  ? "factor of |grad u|^2"
               : kind == "curvature" ? "factor of |H|^2"
                                     : "height of the band; without effect with monitor.average";
    return row;
}

/// The rows of one indicator.
std::vector<ParameterRow> indicator_rows(const std::string& kind) {
    std::vector<ParameterRow> rows;
    if (kind != "gradient" && kind != "magnitude") rows.push_back(alpha_row(kind));
    if (kind == "curvature")
        rows.push_back({.key = "order",
                        .label = "Order",
                        .symbol = "k",
                        .minimum = 0.5,
                        .maximum = 8,
                        .default_value = 1.5,
                        .help = "1.5 for the interpolation error in L2, 1 for its maximum and for gradients; "
                                "larger: more even"});
    if (kind != "band") return rows;
    rows.push_back({.key = "level",
                    .label = "Level",
                    .symbol = "c",
                    .minimum = -1e12,
                    .maximum = 1e12,
                    .default_value = 0.5,
                    .help = "of u; with monitor.normalise 0 is the least and 1 the largest value of u"});
    rows.push_back(
        {.key = "width",
         .label = "Width",
         .symbol = "w",
         .minimum = 1e-6,
         .maximum = 1e12,
         .scale = ParameterScale::logarithmic,
         .default_value = 0.05,
         .help = "of the band, as a difference of u; with monitor.normalise as a part of its range"});
    rows.push_back({.key = "profile",
                    .label = "Profile",
                    .kind = ParameterKind::choice,
                    .default_value = std::string("sech"),
                    .choices = {"sech", "gaussian"},
                    .help = "of the band: sech(z) or exp(-z^2), z = (u - c) / w"});
    return rows;
}

std::vector<ParameterRow> stage_rows() {
    return {
        boolean("normalise", "Normalise",
                "divide u by its range and lengths by the domain's size, so that the numbers have no unit"),
        boolean("average", "Average", "choose which fraction of the cells goes to the feature"),
        {.key = "fraction",
         .label = "Fraction",
         .symbol = "f",
         .minimum = 0,
         .maximum = 0.95,
         .default_value = 0.5,
         .help = "of the cells that go to the feature (Beckett and Mackenzie); 0: a uniform mesh"},
        boolean("limit", "Limit", "bound the monitor from below and above"),
        {.key = "floor",
         .label = "Floor",
         .minimum = 1e-6,
         .maximum = 1,
         .scale = ParameterScale::logarithmic,
         .default_value = 0.01,
         .help = "least value, as a part of the average"},
        {.key = "contrast",
         .label = "Contrast",
         .minimum = 1,
         .maximum = 1e6,
         .scale = ParameterScale::logarithmic,
         .default_value = 1000.0,
         .help = "largest ratio of two values, hence of the areas of two cells"},
        boolean("smooth", "Smooth", "Helmholtz filter"),
        {.key = "smoothing",
         .label = "Smoothing length",
         .symbol = "L",
         .unit = "cells",
         .kind = ParameterKind::real_or_auto,
         .minimum = 0,
         .maximum = 100,
         .default_value = std::string("auto"),
         .help = "in cells of the uniform mesh; auto: as much as the mesh needs to follow the monitor"}};
}

constexpr std::string_view prefix = "u.";

const SourceType& source_of(const Values& values) { return source_type(values.text("u.type")); }

/// The values of u's source, by its own keys.
Values source_values(const Values& values, const Space& space) {
    const SourceType& type = source_of(values);
    return grown_part(values, prefix, type.rows(space), [&](const Values& known) {
        return type.further_rows ? type.further_rows(known, space) : std::vector<ParameterRow>();
    });
}

std::vector<ParameterRow> derived_rows(const Space& space) {
    std::vector<std::string> names;
    for (const SourceType& type : source_types())
        if (is_offered(type, space)) names.push_back(type.name);
    return {{.key = "u.type",
             .label = "u from",
             .kind = ParameterKind::choice,
             .default_value = names.front(),
             .choices = names,
             .help = "where the function u comes from",
             .role = ParameterRole::defines_rows}};
}

std::vector<ParameterRow> further_derived_rows(const Values& values, const Space& space) {
    auto rows = prefixed(all_rows(source_of(values), source_values(values, space), space), prefix);
    const ParameterRow kind = kind_row();
    const std::string name =
        values.has(kind.key) ? values.text(kind.key) : std::get<std::string>(kind.default_value);
    rows.push_back(kind);
    for (ParameterRow& row : indicator_rows(name)) rows.push_back(std::move(row));
    for (ParameterRow& row : stage_rows()) rows.push_back(std::move(row));
    return rows;
}

DerivedOptions options_of(const Values& values) {
    const std::string& kind = values.text("kind");
    DerivedOptions options;
    options.indicator = kind == "arc-length"  ? Indicator::arc_length
                        : kind == "curvature" ? Indicator::curvature
                        : kind == "gradient"  ? Indicator::gradient
                        : kind == "magnitude" ? Indicator::magnitude
                                              : Indicator::band;
    const auto read = [&](const char* key, double& to) {
        if (values.has(key)) to = values.real(key);
    };
    read("alpha", options.alpha), read("order", options.order);
    read("level", options.level), read("width", options.width);
    if (values.has("profile")) options.gaussian = values.text("profile") == "gaussian";
    options.normalise = values.boolean("normalise");
    options.average = values.boolean("average"), options.fraction = values.real("fraction");
    options.limit = values.boolean("limit");
    options.floor = values.real("floor"), options.contrast = values.real("contrast");
    options.smooth = values.boolean("smooth"), options.smoothing = values.real_or_auto("smoothing");
    return options;
}

std::shared_ptr<const Monitor> make_derived(const Values& values, const MonitorContext& context) {
    MadeFunction u = source_of(values).make(source_values(values, context.space), context);
    MonitorReport report{.notes = std::move(u.notes), .advice = std::move(u.advice)};
    for (auto& [key, choices] : u.choices) report.choices[std::string(prefix) + key] = std::move(choices);
    return derived_monitor(std::move(u.function), options_of(values), context, std::move(report));
}

} // namespace

MonitorType derived_monitor_type() {
    return {
        .name = "derived",
        .label = "Derived from u",
        .help = "small cells where a function u, such as the solution of a PDE, needs them",
        .equation = "m = 1 + f/(1 - f) q/<q>, limited and smoothed; q from the indicator of u, such as "
                    "sqrt(1 + a |grad u|²) - 1",
        .rows = derived_rows,
        .make = make_derived,
        .further_rows = further_derived_rows,
        .fields = derived_fields(),
        .stages = {
            {"Function u", "u", {"u."}},
            {"Indicator", "indicator", {"kind", "alpha", "order", "level", "width", "profile", "normalise"}},
            {"Average", "averaged", {"average", "fraction"}},
            {"Limit", "limited", {"limit", "floor", "contrast"}},
            {"Smooth", "monitor", {"smooth", "smoothing"}}}};
}

} // namespace gaspard
