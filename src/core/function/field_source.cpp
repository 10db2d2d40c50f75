// The source whose function is a field of a file, and its rows.
#include "core/base/error.hpp"
#include "core/base/read_data_file.hpp"
#include "core/data/field_file.hpp"
#include "core/function/field_function.hpp"
#include "core/function/field_values.hpp"

#include <cmath>
#include <utility>

namespace gaspard {

static std::size_t memory_of(const FieldData& field) {
    std::size_t numbers = values_of(field).size();
    if (const auto* points = std::get_if<ScatteredData>(&field.data)) numbers += 3 * points->points.size();
    return sizeof field + numbers * sizeof(double);
}

/// One time step of a variable.
static std::shared_ptr<const FieldData> read_step(const std::string& file, const FieldRequest& request,
                                                  const DataContext& context) {
    const std::function<std::shared_ptr<const FieldData>()> read = [&] {
        request.progress(0);
        return std::make_shared<const FieldData>(
            parse_field(read_data_file(file, context.folder), data_file_name(file, context.folder), request));
    };
    if (!context.files) return read();
    const std::string name = is_data_uri(file) ? file : data_file_name(file, context.folder);
    std::string purpose = "field";
    for (const std::int64_t number :
         {request.time, request.level, static_cast<std::int64_t>(request.dimension),
          std::int64_t{request.time_ends}})
        purpose += ' ' + std::to_string(number);
    return context.files->get<FieldData>(name, purpose + ' ' + request.variable, read, &memory_of);
}

/// Of a field that moves, the time step is told whose missing values are not allowed.
static void check_step(const Values& values, const FieldData& field, std::int64_t step) {
    const std::size_t missing = count_missing(values_of(field));
    if (missing > 0 && values.text("missing") == "error")
        refuse_missing(missing, values_of(field).size(), in_step(step));
}

std::shared_ptr<const FieldData> read_field(const Values& values, const DataContext& context) {
    const std::string& file = values.text("file");
    if (file.empty())
        throw InputError(key_name(values, "file") + " is empty; it is the path of a NetCDF, CSV or VTK file");
    const auto report = [&](double done) {
        if (context.progress) context.progress(done, "Reading the field");
    };
    FieldRequest request{values.text("variable"),
                         values.integer("time"),
                         values.has("level") ? values.integer("level") : 0,
                         report,
                         context.stop,
                         context.space.solid ? std::size_t{3} : std::size_t{2}};
    const auto moment = values.real_or_auto("moment");
    if (!moment) return read_step(file, request, context);
    const double step = std::floor(*moment), weight = *moment - step;
    request.time_ends = false;
    request.time = static_cast<std::int64_t>(step);
    const auto before = read_step(file, request, context);
    check_step(values, *before, request.time);
    if (weight == 0) return before;
    ++request.time;
    const auto after = read_step(file, request, context);
    check_step(values, *after, request.time);
    return std::make_shared<const FieldData>(interpolated(*before, *after, weight));
}

ParameterRow field_transform_row() {
    return {.key = "transform",
            .label = "Transform",
            .kind = ParameterKind::choice,
            .default_value = std::string("none"),
            .choices = {"none", "absolute", "square", "logarithm"},
            .help = "what is done to the values: nothing, the absolute value, the square, or the logarithm "
                    "(base 10)"};
}

FieldTransform field_transform(const Values& values) {
    const std::string& transform = values.text("transform");
    return transform == "absolute"    ? FieldTransform::absolute
           : transform == "square"    ? FieldTransform::square
           : transform == "logarithm" ? FieldTransform::logarithm
                                      : FieldTransform::none;
}

std::vector<ParameterRow> field_rows(const Space& space) {
    constexpr double most = 1e6;
    std::vector<ParameterRow> rows = {
        {.key = "file",
         .label = "File",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "a NetCDF, CSV or VTK file (.vtk, .vtu, .vti, ...), relative to the folder of the "
                 "scenario's file",
         .role = ParameterRole::file},
        {.key = "variable",
         .label = "Variable",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "name of the variable, array or column; empty: the first"},
        {.key = "time",
         .label = "Time",
         .kind = ParameterKind::integer,
         .minimum = -1,
         .maximum = most,
         .slider = SliderRange{0, 20},
         .default_value = std::int64_t{0},
         .help = "index of the time step, from 0; -1: the last"},
        {.key = "moment",
         .label = "Moment",
         .symbol = "t",
         .kind = ParameterKind::real_or_auto,
         .minimum = 0,
         .maximum = most,
         .slider = SliderRange{0, 20},
         .default_value = std::string("auto"),
         .help = "a time in time steps of the file: between them, values are interpolated; the clock sets it "
                 "while time passes; auto: the step 'time'",
         .role = ParameterRole::time,
         .detail = true},
        {.key = "level",
         .label = "Level",
         .kind = ParameterKind::integer,
         .minimum = -1,
         .maximum = most,
         .slider = SliderRange{0, 20},
         .default_value = std::int64_t{0},
         .help = "index of the level (height, depth, z), from 0; -1: the last"},
        field_transform_row(),
        {.key = "missing",
         .label = "Missing values",
         .kind = ParameterKind::choice,
         .default_value = std::string("nearest"),
         .choices = {"nearest", "floor", "error"},
         .help = "what stands in for missing values and outside of the data: the nearest value, the "
                 "lowest value, "
                 "or nothing (an error)"},
        {.key = "placement",
         .label = "Placement",
         .kind = ParameterKind::choice,
         .default_value = std::string("auto"),
         .choices = {"auto", "coordinates", "fit"},
         .help = "where the data lie: by their coordinates, fitted to the domain, or by coordinates if "
                 "they cover "
                 "half of the domain"}};
    if (space.solid) // the third direction of a field is that of the solid
        std::erase_if(rows, [](const ParameterRow& row) { return row.key == "level"; });
    return rows;
}

FieldOptions field_options(const Values& values) {
    const std::string &missing = values.text("missing"), &placement = values.text("placement");
    FieldOptions options;
    options.transform = field_transform(values);
    options.missing = missing == "floor"   ? MissingValues::lowest
                      : missing == "error" ? MissingValues::error
                                           : MissingValues::nearest;
    options.placement = placement == "coordinates" ? FieldPlacement::coordinates
                        : placement == "fit"       ? FieldPlacement::fit
                                                   : FieldPlacement::automatic;
    return options;
}

SourceType field_source() {
    return {.name = "field",
            .label = "Field",
            .help = "a variable of a NetCDF, CSV or VTK file",
            .rows = &field_rows,
            .make = [](const Values& values, const DataContext& context) {
                const auto field = read_field(values, context);
                MadeFunction made = field_function(*field, field_options(values), context);
                made.choices["variable"] = field->variables;
                return made;
            }};
}

} // namespace gaspard
