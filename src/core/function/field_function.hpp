// Fields of files as functions on a domain (data/field_file.hpp reads them):
//
//   u(x) = v,  |v|  or  log10 v,      v the field at x
//
// Data on a rectilinear grid are interpolated by cubic splines along its axes (function/line_resampling.hpp),
// scattered points by moving least squares (function/scattered_fit.hpp), onto a regular grid of the domain's
// chart.
//
// Placement. By coordinates: x and y of the data are those of the domain; longitude and latitude those of the
// sphere; points with three coordinates lie on the sphere in their direction from its centre, and on a
// surface in space where they are. Fitted: the box of the data becomes that of the chart (on a sphere the
// whole map, on a surface in space the parameters). Where the domain has no data, the nearest value is used,
// unless `missing` says otherwise.
#pragma once

#include "core/data/field_data.hpp"
#include "core/function/field_options.hpp"
#include "core/function/grid.hpp"
#include "core/function/source.hpp"

#include <memory>
#include <string>
#include <vector>

namespace gaspard {

/// u on a grid of the domain's chart, before it is blurred.
struct FieldGrid {
    Grid grid;
    std::vector<double> values;
    double sigma = 0; ///< the blur, as a length
    double cell = 0;  ///< size of the cells of the uniform mesh
    std::vector<std::string> notes;
};

/// Throws InputError, and Interrupted if asked to stop.
FieldGrid field_grid(const FieldData& field, const FieldOptions& options, const DataContext& context);
/// u, blurred.
MadeFunction field_function(const FieldData& field, const FieldOptions& options, const DataContext& context);

/// Reads the field that the rows describe through the context's files.
std::shared_ptr<const FieldData> read_field(const Values& values, const DataContext& context);

/// The rows of a file and of the options without blur, and the options of such rows.
std::vector<ParameterRow> field_rows(const Space& space);
FieldOptions field_options(const Values& values);
/// One of these rows, which sources of computed fields have as well.
ParameterRow field_transform_row();
FieldTransform field_transform(const Values& values);

} // namespace gaspard
