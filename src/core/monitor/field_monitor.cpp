#include "core/monitor/field_monitor.hpp"

#include "core/base/error.hpp"
#include "core/base/read_data_file.hpp"
#include "core/base/short_number.hpp"
#include "core/data/field_file.hpp"
#include "core/function/chart_extent.hpp"
#include "core/function/density_rows.hpp"
#include "core/function/field_function.hpp"
#include "core/function/image_function.hpp"
#include "core/monitor/field_density.hpp"
#include "core/monitor/grid_density.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// From low to high: 0 to 1.
void scale(std::vector<double>& values, const FieldMonitorOptions& options, std::vector<std::string>& notes) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double low = *least, high = *most;
    const bool constant = !(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)));
    if (constant) notes.push_back("The field is constant on the domain, and the monitor is too.");
    for (double& value : values) {
        const double d = constant ? 0 : std::clamp((value - low) / (high - low), 0.0, 1.0);
        value = std::max(std::pow(options.invert ? 1 - d : d, options.gamma), std::min(options.floor, 1.0));
    }
    if (!constant)
        notes.push_back("On the domain the field is between " + short_number(low) + " and " +
                        short_number(high) + ".");
}

void check_density(const std::vector<double>& values, double floor, const std::string& section) {
    const double lowest = *std::min_element(values.begin(), values.end());
    if (!(std::max(lowest, floor) > 0))
        throw InputError("the field has the value " + short_number(lowest) +
                         ", but a density must be positive; set " + section +
                         ".floor to a positive number, or " + section + ".density = \"scaled\"");
}

std::vector<ParameterRow> monitor_rows(const Space& space) {
    std::vector<ParameterRow> rows = field_rows(space);
    for (ParameterRow& row : field_density_rows()) rows.push_back(std::move(row));
    return rows;
}

} // namespace

std::vector<ParameterRow> field_density_rows() {
    std::vector<ParameterRow> rows = {
        {.key = "density",
         .label = "Density",
         .kind = ParameterKind::choice,
         .default_value = std::string("scaled"),
         .choices = {"scaled", "values"},
         .help = "scaled: from 1 at the lowest value to the contrast at the highest; values: the density is "
                 "the field"},
        contrast_row("the largest ratio of densities (1 / cell area), if they are scaled"),
        invert_row("small cells where the field is low instead of high, if densities are scaled"),
        gamma_row("exponent of the scaled values: larger than 1 leaves the highest, smaller lifts the low"),
        {.key = "floor",
         .label = "Floor",
         .minimum = 0,
         .maximum = 1e12,
         .slider = SliderRange{0, 1},
         .default_value = 0.0,
         .help = "lower values count as this one: scaled values, from 0 to 1, or values of the field"},
        blur_row()};
    rows.back().unit = "cells"; // of the blur
    return rows;
}

FieldMonitorOptions field_density_options(const Values& values, FieldOptions field) {
    field.blur = values.real("blur");
    return {field,
            values.text("density") == "scaled",
            values.real("contrast"),
            values.boolean("invert"),
            values.real("gamma"),
            values.real("floor")};
}

std::shared_ptr<const Monitor> field_density(const FieldData& field, FieldMonitorOptions options,
                                             const DataContext& context, const std::string& section) {
    const double asked = options.field.blur;
    options.field.blur = std::max(asked, least_blur);
    FieldGrid made = field_grid(field, options.field, context);
    const DomainGrid domain = domain_on(made.grid, context);
    go_on_beside(domain, made.values);
    if (options.scaled) {
        scale(made.values, options, made.notes);
        to_density(made.values, options.contrast);
    } else {
        check_density(made.values, options.floor, section);
        for (double& value : made.values) value = std::max(value, options.floor);
    }
    made.sigma = blur_density(domain, made.values, made.sigma, context);
    const double cells = made.sigma / made.cell;
    const std::string instead = cells > asked * 1.005 ? " instead of " + exact_number(asked) : "";
    made.notes.push_back("The field is blurred over " + in_cells(cells) + instead +
                         ", so that the mesh can follow.");
    MonitorReport report{std::move(made.notes)};
    if (!field.variables.empty()) report.choices["variable"] = field.variables;
    return grid_density(std::move(made.grid), std::move(made.values), std::move(report), context.space.kind);
}

std::shared_ptr<const Monitor> field_monitor(const FieldData& field, const FieldMonitorOptions& options,
                                             const DataContext& context) {
    return field_density(field, options, context, "monitor");
}

std::shared_ptr<const Monitor> field_monitor(const std::string& file, const FieldRequest& request,
                                             const FieldMonitorOptions& options, const DataContext& context) {
    const FieldData field =
        parse_field(read_data_file(file, context.folder), data_file_name(file, context.folder), request);
    return field_density(field, options, context, "monitor");
}

MonitorType field_file_monitor() {
    return {.name = "field",
            .label = "Field",
            .help = "small cells where a variable of a NetCDF, CSV or VTK file is large",
            .equation = "m(x) = 1 + (C - 1) ((u - low) / (high - low))^γ, blurred",
            .rows = &monitor_rows,
            .make = [](const Values& values, const MonitorContext& context) {
                return field_density(*read_field(values, context),
                                     field_density_options(values, field_options(values)), context,
                                     values.section());
            }};
}

} // namespace gaspard
