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
#include "core/session/time_series.hpp"
#include "core/tessellate/colouring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

void append_base64(std::string& text, std::string_view bytes) {
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(bytes[i])}; };
    const std::size_t begin = text.size(), whole = bytes.size() / 3 * 3;
    text.resize(begin + (bytes.size() + 2) / 3 * 4, '=');
    char* to = text.data() + begin;
    const auto put = [&](std::uint32_t group, int count) {
        for (int k = 0; k < count; ++k) to[k] = digits[group >> (18 - 6 * k) & 63u];
        to += 4;
    };
    for (std::size_t i = 0; i < whole; i += 3) put(byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2), 4);
    if (bytes.size() - whole == 1) put(byte(whole) << 16, 2);
    if (bytes.size() - whole == 2) put(byte(whole) << 16 | byte(whole + 1) << 8, 3);
}

/// Appends the arrays of one section, such as PointData, to a text.
class Arrays {
  public:
    explicit Arrays(std::string& text) : text_(text) {}

    void reals(std::string_view name, int components, std::span<const double> values,
               std::string_view more = {}) {
        begin(values.size() * sizeof(double));
        for (const double value : values) {
            GASPARD_CHECK(std::isfinite(value));
            append_little_endian(block_, value);
        }
        add("Float64", name, components, more);
    }

    void vectors(std::string_view name, const Points& points) {
        std::vector<double> values;
        values.reserve(3 * points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            values.insert(values.end(), {points.x[i], points.y[i], points.z[i]});
        reals(name, 3, values);
    }

    void integers(std::string_view name, std::span<const std::int32_t> values, std::string_view more = {}) {
        begin(values.size() * sizeof(std::int32_t));
        for (const std::int32_t value : values) append_little_endian(block_, value);
        add("Int32", name, 1, more);
    }

    void bytes(std::string_view name, std::string_view values) {
        begin(values.size());
        block_ += values;
        add("UInt8", name, 1, {});
    }

  private:
    /// A block is its length, then `size` bytes.
    void begin(std::size_t size) {
        block_.clear();
        block_.reserve(sizeof(std::uint64_t) + size);
        append_little_endian(block_, static_cast<std::uint64_t>(size));
    }
    void add(std::string_view type, std::string_view name, int components, std::string_view more) {
        text_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + xml_escape(name) +
                 "\" NumberOfComponents=\"" + std::to_string(components) + '"' + std::string(more) +
                 " format=\"binary\">";
        append_base64(text_, block_);
        text_ += "</DataArray>\n";
    }

    std::string& text_;
    std::string block_; ///< workspace
};

/// What belongs to the mesh as a whole.
void field_data(std::string& text, const StepReport& report) {
    Arrays arrays(text);
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
    for (std::size_t i = always.size(); i < columns.size(); ++i)
        if (!is_wall_time(columns[i])) real(columns[i], report.value(columns[i]));
}

void point_data(std::string& text, const Snapshot& snapshot) {
    Arrays arrays(text);
    for (const auto& field : snapshot.fields)
        if (field.place == FieldPlace::node) arrays.reals(field.name, 1, field.values);
    arrays.vectors("displacement", snapshot.x - snapshot.mesh->nodes);
    arrays.vectors("xi", snapshot.mesh->nodes);
}

void cell_data(std::string& text, const Snapshot& snapshot) {
    Arrays arrays(text);
    for (const auto& field : snapshot.fields)
        if (field.place == FieldPlace::cell) arrays.reals(field.name, 1, field.values);
    ColouringMaker maker;
    arrays.reals("measure", 1, maker.measures(snapshot));
    if (const CellQuality* quality = maker.quality(snapshot))
        for (const QualityMeasureInfo& measure : quality_measures())
            if (!(quality->*measure.values).empty()) arrays.reals(measure.name, 1, quality->*measure.values);
}

/// Files of version 1.0, the only one that all programs read, have two edges of Lagrange hexahedra exchanged:
/// the last two, as VTK 8 numbers them.
std::vector<std::int32_t> connectivity(const Mesh& mesh) {
    std::vector<std::int32_t> nodes = mesh.cells;
    if (mesh.kind.shape != CellShape::hexahedron || mesh.kind.order < 3) return nodes;
    const std::ptrdiff_t inner = mesh.kind.order - 1, first = 8 + 10 * inner,
                         each = nodes_per_cell(mesh.kind);
    for (auto cell = nodes.begin(); cell != nodes.end(); cell += each)
        std::swap_ranges(cell + first, cell + first + inner, cell + first + inner);
    return nodes;
}

void cells(std::string& text, const Mesh& mesh) {
    Arrays arrays(text);
    arrays.integers("connectivity", connectivity(mesh));
    GASPARD_CHECK(mesh.cells.size() <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()));
    std::vector<std::int32_t> ends;
    for (std::size_t c = 1; c <= mesh.cell_count(); ++c)
        ends.push_back(static_cast<std::int32_t>(c) * nodes_per_cell(mesh.kind));
    arrays.integers("offsets", ends);
    arrays.bytes("types",
                 std::string(mesh.cell_count(), static_cast<char>(cell_type_numbers(mesh.kind).vtk)));
}

/// Appends an element whose content `write` appends.
template <class Write>
void section(std::string& text, const std::string& name, const Write& write,
             const std::string& attributes = {}) {
    text += "<" + name + attributes + ">\n";
    write();
    text += "</" + name + ">\n";
}

} // namespace

void write_vtu(const std::filesystem::path& file, const Snapshot& snapshot) {
    const Mesh& mesh = *snapshot.mesh;
    GASPARD_CHECK(snapshot.x.size() == mesh.node_count());
    const std::string counts = " NumberOfPoints=\"" + std::to_string(mesh.node_count()) +
                               "\" NumberOfCells=\"" + std::to_string(mesh.cell_count()) + '"';
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Gaspard " + std::string(version()) +
                       " -->\n"; // the one buffer, to which everything is appended
    const auto piece = [&] {
        section(
            text, "PointData", [&] { point_data(text, snapshot); },
            " Scalars=\"monitor\" Vectors=\"displacement\"");
        section(text, "CellData", [&] { cell_data(text, snapshot); });
        section(text, "Points", [&] { Arrays(text).vectors("x", snapshot.x); });
        section(text, "Cells", [&] { cells(text, mesh); });
    };
    const auto grid = [&] {
        section(text, "FieldData", [&] { field_data(text, snapshot.report); });
        section(text, "Piece", piece, counts);
    };
    section(
        text, "VTKFile", [&] { section(text, "UnstructuredGrid", grid); },
        " type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"");
    write_atomically(file, text);
}

} // namespace gaspard
