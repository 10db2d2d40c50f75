// adapted.vtu: VTK's XML file of an unstructured grid; every array is binary in base64, so that the file is
// well-formed XML and the numbers are exact.
#include "core/base/check.hpp"
#include "core/base/version.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/cell_types.hpp"
#include "core/io/formats.hpp"
#include "core/io/little_endian.hpp"
#include "core/io/xml.hpp"
#include "core/session/report_columns.hpp"
#include "core/tessellate/colouring.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

std::string base64(std::string_view bytes) {
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

/// Arrays of one section, such as PointData.
class Arrays {
  public:
    void reals(std::string_view name, int components, std::span<const double> values,
               std::string_view more = {}) {
        std::string bytes;
        for (const double value : values) {
            GASPARD_CHECK(std::isfinite(value));
            append_little_endian(bytes, value);
        }
        add("Float64", name, components, bytes, more);
    }

    void vectors(std::string_view name, const Points& points) {
        std::vector<double> values;
        values.reserve(3 * points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            values.insert(values.end(), {points.x[i], points.y[i], points.z[i]});
        reals(name, 3, values);
    }

    void integers(std::string_view name, std::span<const std::int32_t> values, std::string_view more = {}) {
        std::string bytes;
        for (const std::int32_t value : values) append_little_endian(bytes, value);
        add("Int32", name, 1, bytes, more);
    }

    void bytes(std::string_view name, std::string_view values) { add("UInt8", name, 1, values, {}); }

    const std::string& text() const { return text_; }

  private:
    /// `bytes` follow their length.
    void add(std::string_view type, std::string_view name, int components, std::string_view bytes,
             std::string_view more) {
        std::string block;
        append_little_endian(block, static_cast<std::uint64_t>(bytes.size()));
        block += bytes;
        text_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + xml_escape(name) +
                 "\" NumberOfComponents=\"" + std::to_string(components) + '"' + std::string(more) +
                 " format=\"binary\">" + base64(block) + "</DataArray>\n";
    }

    std::string text_;
};

/// What belongs to the mesh as a whole.
std::string field_data(const StepReport& report) {
    Arrays arrays;
    const std::string_view one = " NumberOfTuples=\"1\"";
    const auto real = [&](std::string_view name, std::optional<double> value) {
        if (value) arrays.reals(name, 1, std::span(&*value, 1), one);
    };
    const auto integer = [&](std::string_view name, std::size_t value) {
        GASPARD_CHECK(value <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()));
        const auto narrow = static_cast<std::int32_t>(value);
        arrays.integers(name, std::span(&narrow, 1), one);
    };
    integer("iteration", static_cast<std::size_t>(report.iteration));
    static constexpr std::array<std::string_view, 5> always = {"residual", "theta", "equidistribution",
                                                               "min_jacobian", "max_jacobian"};
    const auto columns = report_columns(always, std::span(&report, 1));
    for (std::size_t i = 0; i < always.size(); ++i) real(columns[i], report.value(columns[i]));
    if (report.tangled_cells) integer("tangled_cells", *report.tangled_cells);
    for (std::size_t i = always.size(); i < columns.size(); ++i) real(columns[i], report.value(columns[i]));
    return arrays.text();
}

std::string point_data(const Snapshot& snapshot) {
    Arrays arrays;
    for (const auto& field : snapshot.fields)
        if (field.place == FieldPlace::node) arrays.reals(field.name, 1, field.values);
    arrays.vectors("displacement", snapshot.x - snapshot.mesh->nodes);
    arrays.vectors("xi", snapshot.mesh->nodes);
    return arrays.text();
}

std::string cell_data(const Snapshot& snapshot) {
    Arrays arrays;
    for (const auto& field : snapshot.fields)
        if (field.place == FieldPlace::cell) arrays.reals(field.name, 1, field.values);
    arrays.reals("measure", 1, ColouringMaker().measures(snapshot));
    return arrays.text();
}

std::string cells(const Mesh& mesh) {
    Arrays arrays;
    arrays.integers("connectivity", mesh.cells);
    GASPARD_CHECK(mesh.cells.size() <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()));
    std::vector<std::int32_t> ends;
    for (std::size_t c = 1; c <= mesh.cell_count(); ++c)
        ends.push_back(static_cast<std::int32_t>(c) * nodes_per_cell(mesh.kind));
    arrays.integers("offsets", ends);
    arrays.bytes("types",
                 std::string(mesh.cell_count(), static_cast<char>(cell_type_numbers(mesh.kind).vtk)));
    return arrays.text();
}

std::string section(const std::string& name, const std::string& content, const std::string& attributes = {}) {
    return "<" + name + attributes + ">\n" + content + "</" + name + ">\n";
}

} // namespace

void write_vtu(const std::filesystem::path& file, const Snapshot& snapshot) {
    const Mesh& mesh = *snapshot.mesh;
    GASPARD_CHECK(snapshot.x.size() == mesh.node_count());
    Arrays points;
    points.vectors("x", snapshot.x);
    const std::string piece =
        section("PointData", point_data(snapshot), " Scalars=\"monitor\" Vectors=\"displacement\"") +
        section("CellData", cell_data(snapshot)) + section("Points", points.text()) +
        section("Cells", cells(mesh));
    const std::string counts = " NumberOfPoints=\"" + std::to_string(mesh.node_count()) +
                               "\" NumberOfCells=\"" + std::to_string(mesh.cell_count()) + '"';
    write_atomically(
        file, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Gaspard " + std::string(version()) +
                  " -->\n" +
                  section("VTKFile",
                          section("UnstructuredGrid", section("FieldData", field_data(snapshot.report)) +
                                                          section("Piece", piece, counts)),
                          " type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                          "header_type=\"UInt64\""));
}

} // namespace gaspard
