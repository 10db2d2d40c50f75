// Files with scalar fields, recognised by their content:
//
//   NetCDF, classic and HDF5-based, with CF's conventions for coordinates, packing and missing values
// (netcdf_field)
//   CSV: a matrix, or columns with coordinates and values
// (csv_field)
//   VTK: legacy files, and XML files of image data, rectilinear, structured and unstructured grids, and
//   polygons; values at points, values of cells at their centres, vectors by their length
// (vtk_field)
#pragma once

#include "core/data/field_data.hpp"

#include <string>
#include <string_view>

namespace gaspard {

/// Reads one variable from the bytes of a file. Throws InputError with one sentence that begins with
/// `origin`, the file's name for messages.
FieldData parse_field(std::string_view bytes, const std::string& origin, const FieldRequest& request = {});

/// The readers of each kind. Their InputErrors do not name the file.
FieldData parse_csv_field(std::string_view text, const FieldRequest& request);
FieldData parse_netcdf_field(std::string_view bytes, const FieldRequest& request);
FieldData parse_legacy_vtk_field(std::string_view bytes, const FieldRequest& request);
FieldData parse_xml_vtk_field(std::string_view bytes, const FieldRequest& request);

} // namespace gaspard
