#include "core/data/field_file.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>

namespace gaspard {

namespace {

using Reader = FieldData (*)(std::string_view, const FieldRequest&);

/// How the content of a kind of file begins.
struct FileKind {
    std::string_view begins;
    Reader read;           ///< null: it is not read
    std::string_view name; ///< of a kind that is not read
};

constexpr std::array<FileKind, 22> kinds = {{
    {"CDF", &parse_netcdf_field, {}},
    {"\x89HDF", &parse_netcdf_field, {}},
    {"# vtk DataFile", &parse_legacy_vtk_field, {}},
    {"<VTKFile", &parse_xml_vtk_field, {}},
    {"<?xml", &parse_xml_vtk_field, {}},
    {"<!--", &parse_xml_vtk_field, {}},
    {"\x0e\x03\x13\x01", nullptr, "an HDF4 file; convert it to NetCDF (h4tonccf)"},
    {"GRIB", nullptr, "a GRIB file; convert it to NetCDF (cdo -f nc copy)"},
    {"\x93NUMPY", nullptr, "a file of numpy (.npy); save it as CSV (numpy.savetxt)"},
    {"PK\x03\x04", nullptr, "a zip archive (.npz, .xlsx); save its data as CSV"},
    {"\x1f\x8b", nullptr, "a gzip-compressed file; decompress it first (gunzip)"},
    {"\x89PNG", nullptr, "a PNG image; use the monitor 'image'"},
    {"\xff\xd8\xff", nullptr, "a JPEG image; use the monitor 'image'"},
    {"II*", nullptr, "a TIFF image; convert it to NetCDF (gdal_translate -of netCDF)"},
    {std::string_view("MM\0*", 4), nullptr, "a TIFF image; convert it to NetCDF (gdal_translate -of netCDF)"},
    {"$MeshFormat", nullptr, "a Gmsh file; convert it to VTU (meshio convert)"},
    {"SIMPLE  =", nullptr, "a FITS file"},
    {"glTF", nullptr, "a glTF file"},
    {"ply", nullptr, "a PLY file"},
    {"%PDF", nullptr, "a PDF file"},
    {"{", nullptr, "a JSON file"},
    {"<", nullptr, "an XML file, but not a VTK file"},
}};

bool is_text(std::string_view bytes) {
    return std::none_of(bytes.begin(), bytes.end(), [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code < 32 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v';
    });
}

Reader reader_of(std::string_view bytes) {
    std::string_view begin = bytes;
    if (begin.starts_with("\xef\xbb\xbf")) begin.remove_prefix(3);
    begin.remove_prefix(std::min(begin.find_first_not_of(" \t\r\n"), begin.size()));
    if (begin.empty()) throw InputError("it is empty");
    for (const FileKind& kind : kinds) {
        if (!begin.starts_with(kind.begins)) continue;
        if (kind.read == nullptr) throw InputError("it is " + std::string(kind.name));
        return kind.read;
    }
    if (!is_text(begin.substr(0, 4096)))
        throw InputError("it is none of the kinds of file that are read: NetCDF, CSV, VTK");
    return &parse_csv_field;
}

} // namespace

std::string in_step(std::int64_t step) {
    return " in time step " + std::to_string(step) + " (the first is 0)";
}

FieldData parse_field(std::string_view bytes, const std::string& origin, const FieldRequest& request) {
    try {
        FieldData field = reader_of(bytes)(bytes, request);
        if (count_missing(values_of(field)) == values_of(field).size())
            throw InputError("all values of '" + field.variable + "' are missing" +
                             (request.time > 0 || !request.time_ends ? in_step(request.time) : ""));
        if (!request.time_ends && field.time_steps == 1)
            field.notes.emplace_back("The field has one time step, and does not move while time passes.");
        return field;
    } catch (const InputError& error) {
        throw InputError("cannot read " + origin + ": " + error.what());
    }
}

} // namespace gaspard
