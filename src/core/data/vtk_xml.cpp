// XML files of VTK (vtk.org, "VTK XML Formats"): .vti, .vtr, .vts, .vtu, .vtp. Arrays are text, base64, or
// appended (raw or base64), compressed by zlib or not, with headers of 32 or 64 bits, in both byte orders.
#include "core/base/error.hpp"
#include "core/base/number_text.hpp"
#include "core/data/field_file.hpp"
#include "core/data/vtk_data.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <new>
#include <pugixml.hpp>
#include <zlib.h>

namespace gaspard {

namespace {

using Node = pugi::xml_node;

constexpr std::size_t most_array_bytes = largest_field * 8;

std::string excerpt(std::string_view word) { return std::string(word.substr(0, 60)); }

/// The file as XML without its appended data, and these.
struct Parts {
    std::string xml;
    std::string_view appended; ///< what follows '_'
    bool raw = false;
};

/// Raw appended data are not XML, so they are cut out before the file is parsed.
Parts split_file(std::string_view bytes) {
    const auto begin = bytes.find("<AppendedData");
    if (begin == std::string_view::npos) return {std::string(bytes), {}, false};
    const auto close = bytes.find('>', begin);
    const auto end = bytes.rfind("</AppendedData>");
    if (close == std::string_view::npos || end == std::string_view::npos || end < close)
        throw InputError("its <AppendedData> does not end");
    const auto underscore = bytes.find('_', close);
    if (underscore == std::string_view::npos || underscore > end)
        throw InputError("its <AppendedData> has no '_' before the data");
    return {std::string(bytes.substr(0, close + 1)) + std::string(bytes.substr(end)),
            bytes.substr(underscore + 1, end - underscore - 1),
            bytes.substr(begin, close - begin).find("raw") != std::string_view::npos};
}

template <class Number>
std::vector<Number> list_of(const Node& node, const char* attribute, std::size_t count) {
    std::string_view text = node.attribute(attribute).value();
    std::vector<Number> all;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        if (text.empty()) break;
        Number one{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), one);
        if (error != std::errc() || all.size() == count)
            throw InputError("the attribute " + std::string(attribute) + " is '" +
                             excerpt(node.attribute(attribute).value()) + "'");
        all.push_back(one);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    if (all.size() != count)
        throw InputError("the attribute " + std::string(attribute) + " must have " + std::to_string(count) +
                         " numbers");
    return all;
}

std::size_t count_of(const Node& node, const char* attribute, std::size_t otherwise) {
    if (!node.attribute(attribute)) return otherwise;
    const std::size_t count = list_of<std::size_t>(node, attribute, 1)[0];
    if (count > largest_field)
        throw InputError(std::string(attribute) + " is larger than " + std::to_string(largest_field));
    return count;
}

/// How arrays are stored in the whole file.
struct Encoding {
    bool big_endian = false, compressed = false;
    std::size_t header = 4; ///< bytes of a number in headers
    std::string_view appended;
    bool raw = false;
};

class ArrayReader {
  public:
    ArrayReader(Encoding encoding, const FieldRequest& request) : encoding_(encoding), request_(&request) {}

    /// All numbers of an array, `count` at most.
    std::vector<double> read(const Node& array, std::size_t count) const {
        const std::string name = "'" + excerpt(array.attribute("Name").value()) + "'";
        const auto type = vtk_type(array.attribute("type").value());
        if (!type)
            throw InputError("the type '" + excerpt(array.attribute("type").value()) + "' is not read");
        const std::string_view format = array.attribute("format").value();
        std::vector<double> numbers;
        if (format.empty() || format == "ascii")
            numbers = ascii(array, name, count);
        else if (format == "binary")
            numbers = decode(block_of_base64(array.text().get(), name, count * type->bytes), *type);
        else if (format == "appended")
            numbers = decode(appended(array, name, count * type->bytes), *type);
        else
            throw InputError(name + " has the format '" + excerpt(format) + "'");
        if (numbers.size() != count)
            throw InputError(name + " has " + std::to_string(numbers.size()) + " numbers instead of " +
                             std::to_string(count));
        return numbers;
    }

  private:
    std::vector<double> ascii(const Node& array, const std::string& name, std::size_t count) const {
        std::string_view text = array.text().get();
        std::vector<double> all;
        while (true) {
            text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
            if (text.empty()) return all;
            if (all.size() % 4096 == 0)
                check_stop(*request_, static_cast<double>(all.size()) / static_cast<double>(count + 1));
            const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
            const auto number = vtk_number(word);
            if (!number) throw InputError(name + " has '" + excerpt(word) + "' where a number is expected");
            if (all.size() == count)
                throw InputError(name + " has more than " + std::to_string(count) + " numbers");
            all.push_back(*number);
            text.remove_prefix(word.size());
        }
    }

    std::vector<double> decode(const std::string& bytes, const VtkType& type) const {
        return vtk_numbers(bytes, type, encoding_.big_endian);
    }

    std::size_t header_number(std::string_view bytes, std::size_t index) const {
        const std::size_t size = encoding_.header;
        if (bytes.size() / size <= index) throw InputError("an array ends within its header");
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < size; ++k)
            value = value << 8 | static_cast<unsigned char>(
                                     bytes[index * size + (encoding_.big_endian ? k : size - 1 - k)]);
        if (value > most_array_bytes) throw InputError("an array is too large, or its header is damaged");
        return static_cast<std::size_t>(value);
    }

    /// Bytes of the header: its size, or of compressed data the number of blocks, their size, the size of the
    /// last, and the compressed size of each.
    std::size_t header_size(std::string_view bytes) const {
        return encoding_.header * (encoding_.compressed ? 3 + header_number(bytes, 0) : 1);
    }

    std::size_t stored_size(std::string_view header) const {
        if (!encoding_.compressed) return header_number(header, 0);
        std::size_t sum = 0;
        for (std::size_t i = 0; i < header_number(header, 0); ++i) sum += header_number(header, 3 + i);
        return sum;
    }

    std::string appended(const Node& array, const std::string& name, std::size_t limit) const {
        const std::size_t offset = list_of<std::size_t>(array, "offset", 1)[0];
        if (offset >= encoding_.appended.size())
            throw InputError(name + " begins beyond the end of the appended data");
        const std::string_view from = encoding_.appended.substr(offset);
        if (!encoding_.raw) return block_of_base64(from, name, limit);
        const std::size_t header = header_size(from), size = stored_size(from.substr(0, header));
        if (header > from.size() || size > from.size() - header)
            throw InputError(name + " ends beyond the end of the appended data");
        return unpack(from.substr(0, header), from.substr(header, size), name, limit);
    }

    static std::string bytes_of(std::string_view base64, const std::string& name) {
        auto bytes = decode_base64(base64);
        if (!bytes) throw InputError(name + " is not valid base64");
        return std::move(*bytes);
    }

    /// Header and data are encoded together, or, if they are compressed, each for itself.
    std::string block_of_base64(std::string_view text, const std::string& name, std::size_t limit) const {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        const auto digits = [](std::size_t bytes) { return (bytes + 2) / 3 * 4; };
        const std::string begin = bytes_of(text.substr(0, digits(3 * encoding_.header)), name);
        const std::size_t header = header_size(begin);
        if (digits(header) > text.size()) throw InputError(name + " ends within its header");
        const std::string head = bytes_of(text.substr(0, digits(header)), name).substr(0, header);
        const std::size_t size = stored_size(head);
        const std::size_t skip = encoding_.compressed ? digits(header) : 0;
        const std::size_t wanted = digits(encoding_.compressed ? size : header + size);
        if (wanted > text.size() - skip)
            throw InputError(name + " ends before its " + std::to_string(size) + " bytes");
        std::string bytes = bytes_of(text.substr(skip, wanted), name);
        if (!encoding_.compressed) bytes.erase(0, header);
        if (bytes.size() < size)
            throw InputError(name + " ends before its " + std::to_string(size) + " bytes");
        bytes.resize(size);
        return unpack(head, bytes, name, limit);
    }

    /// `limit`: no more bytes than these are expected.
    std::string unpack(std::string_view header, std::string_view stored, const std::string& name,
                       std::size_t limit) const {
        if (!encoding_.compressed) return std::string(stored);
        const std::size_t blocks = header_number(header, 0), whole = header_number(header, 1),
                          last = header_number(header, 2);
        if (blocks == 0) return {};
        std::string bytes;
        for (std::size_t i = 0; i < blocks; ++i) {
            check_stop(*request_, static_cast<double>(i) / static_cast<double>(blocks));
            const std::size_t packed = header_number(header, 3 + i), before = bytes.size(),
                              size = i + 1 == blocks && last > 0 ? last : whole;
            if (before + size > limit)
                throw InputError(name + " has more bytes than its number of values needs");
            bytes.resize(before + size);
            uLongf length = size;
            const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &length,
                                          reinterpret_cast<const Bytef*>(stored.data()), packed);
            if (status != Z_OK || length != size) throw InputError(name + " has damaged compressed data");
            stored.remove_prefix(packed);
        }
        return bytes;
    }

    Encoding encoding_;
    const FieldRequest* request_;
};

Encoding encoding_of(const Node& root, const Parts& parts) {
    Encoding encoding{.appended = parts.appended, .raw = parts.raw};
    encoding.big_endian = std::string_view(root.attribute("byte_order").value()) == "BigEndian";
    encoding.header = std::string_view(root.attribute("header_type").value()) == "UInt64" ? 8 : 4;
    const std::string_view compressor = root.attribute("compressor").value();
    encoding.compressed = !compressor.empty();
    if (encoding.compressed && compressor != "vtkZLibDataCompressor")
        throw InputError("it is compressed by " + excerpt(compressor) +
                         "; only vtkZLibDataCompressor is read");
    return encoding;
}

class XmlReader {
  public:
    XmlReader(const Node& root, const Parts& parts, const FieldRequest& request)
        : arrays_(encoding_of(root, parts), request), request_(&request) {
        const std::string type = root.attribute("type").value();
        if (type.starts_with('P') && type != "PolyData")
            throw InputError("it only lists the files of a parallel run (" + excerpt(type) +
                             "); read one of these, or merge them");
        const Node grid = root.child(type.c_str());
        if (type == "ImageData")
            image(grid);
        else if (type == "RectilinearGrid")
            rectilinear(grid);
        else if (type == "StructuredGrid")
            structured(grid);
        else if (type == "UnstructuredGrid" || type == "PolyData")
            unstructured(grid, type == "PolyData");
        else
            throw InputError(
                "its type is '" + excerpt(type) +
                "', not ImageData, RectilinearGrid, StructuredGrid, UnstructuredGrid or PolyData");
    }

    FieldData field() const { return vtk_field(file_, *request_); }

  private:
    static Node only_piece(const Node& grid) {
        const Node piece = grid.child("Piece");
        if (!piece) throw InputError("it has no <Piece>");
        if (piece.next_sibling("Piece")) throw InputError("it has several pieces; merge them first");
        return piece;
    }

    /// Points along each direction of a structured piece.
    void read_extent(const Node& grid, const Node& piece) {
        const auto extent = list_of<std::int64_t>(piece.attribute("Extent") ? piece : grid,
                                                  piece.attribute("Extent") ? "Extent" : "WholeExtent", 6);
        constexpr auto far = static_cast<std::int64_t>(largest_field),
                       longest = static_cast<std::int64_t>(longest_axis);
        for (std::size_t d = 0; d < 3; ++d) {
            const std::int64_t low = extent[2 * d], high = extent[2 * d + 1];
            if (low < -far || high > far || high < low || high - low >= longest)
                throw InputError("its Extent is not valid");
            first_[d] = low;
            count_[d] = static_cast<std::size_t>(high - low) + 1;
        }
        checked_product(count_[0], count_[1], count_[2], "points");
    }

    std::size_t points() const { return count_[0] * count_[1] * count_[2]; }
    std::size_t structured_cells() const {
        std::size_t cells = 1;
        for (const std::size_t one : count_) cells *= std::max<std::size_t>(one, 2) - 1;
        return cells;
    }

    void image(const Node& grid) {
        const Node piece = only_piece(grid);
        read_extent(grid, piece);
        const auto vector = [&](const char* name, double otherwise) {
            return grid.attribute(name) ? list_of<double>(grid, name, 3) : std::vector<double>(3, otherwise);
        };
        const auto origin = vector("Origin", 0), spacing = vector("Spacing", 1);
        if (grid.attribute("Direction") &&
            list_of<double>(grid, "Direction", 9) != std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1})
            throw InputError("its Direction is not the identity, which is not read");
        file_.axes.emplace();
        for (std::size_t d = 0; d < 3; ++d)
            for (std::size_t i = 0; i < count_[d]; ++i)
                (*file_.axes)[d].push_back(
                    origin[d] + static_cast<double>(first_[d] + static_cast<std::int64_t>(i)) * spacing[d]);
        add_arrays(piece, points(), structured_cells());
    }

    void rectilinear(const Node& grid) {
        const Node piece = only_piece(grid);
        read_extent(grid, piece);
        file_.axes.emplace();
        Node array = piece.child("Coordinates").child("DataArray");
        for (std::size_t d = 0; d < 3; ++d, array = array.next_sibling("DataArray")) {
            if (!array) throw InputError("its <Coordinates> must have three arrays");
            (*file_.axes)[d] = arrays_.read(array, count_[d]);
        }
        add_arrays(piece, points(), structured_cells());
    }

    void structured(const Node& grid) {
        const Node piece = only_piece(grid);
        read_extent(grid, piece);
        file_.structure = count_;
        file_.points = read_points(piece, points());
        add_arrays(piece, points(), structured_cells());
    }

    void unstructured(const Node& grid, bool polygons) {
        const Node piece = only_piece(grid);
        const std::size_t count = count_of(piece, "NumberOfPoints", 0);
        static constexpr std::array<const char*, 4> kinds = {"Verts", "Lines", "Polys", "Strips"};
        std::vector<std::pair<Node, std::size_t>> lists;
        if (!polygons) lists.emplace_back(piece.child("Cells"), count_of(piece, "NumberOfCells", 0));
        for (const char* kind : kinds)
            if (polygons)
                lists.emplace_back(piece.child(kind),
                                   count_of(piece, (std::string("NumberOf") + kind).c_str(), 0));
        std::size_t cells = 0;
        for (const auto& list : lists) cells += list.second;
        file_.points = read_points(piece, count);
        add_arrays(piece, count, cells);
        file_.cells = [this, lists] {
            VtkCells all{{0}, {}};
            for (const auto& [node, number] : lists) append_cells(all, node, number);
            return all;
        };
    }

    void append_cells(VtkCells& all, const Node& node, std::size_t number) const {
        if (number == 0) return;
        const Node offsets = find_array(node, "offsets"), connectivity = find_array(node, "connectivity");
        const std::size_t before = all.connectivity.size();
        std::size_t last = 0;
        for (const double end : arrays_.read(offsets, number)) {
            if (!(end >= 0) || end > static_cast<double>(largest_field))
                throw InputError("an offset of a cell is out of range");
            last = static_cast<std::size_t>(end);
            all.offsets.push_back(before + last);
        }
        for (const double point : arrays_.read(connectivity, last)) {
            if (!(point >= 0) || point > static_cast<double>(largest_field))
                throw InputError("an index of a cell is out of range");
            all.connectivity.push_back(static_cast<std::size_t>(point));
        }
    }

    static Node find_array(const Node& node, const char* name) {
        const Node found = node.find_child_by_attribute("DataArray", "Name", name);
        if (!found) throw InputError(std::string("its cells have no array '") + name + "'");
        return found;
    }

    std::vector<double> read_points(const Node& piece, std::size_t count) const {
        const Node array = piece.child("Points").child("DataArray");
        if (!array) throw InputError("it has no <Points>");
        return arrays_.read(array, checked_product(count, 3, 1, "coordinates"));
    }

    void add_arrays(const Node& piece, std::size_t points, std::size_t cells) {
        for (const bool of_cells : {false, true})
            for (const Node& array : piece.child(of_cells ? "CellData" : "PointData").children("DataArray")) {
                const std::size_t components =
                    std::max<std::size_t>(count_of(array, "NumberOfComponents", 1), 1);
                if (!vtk_type(array.attribute("type").value())) continue;
                const std::size_t tuples = of_cells ? cells : points;
                file_.arrays.push_back({array.attribute("Name").value(), of_cells, components,
                                        [this, array, components, tuples] {
                                            return arrays_.read(
                                                array, checked_product(components, tuples, 1, "numbers"));
                                        }});
            }
    }

    ArrayReader arrays_;
    const FieldRequest* request_;
    VtkFile file_;
    std::array<std::int64_t, 3> first_{};
    std::array<std::size_t, 3> count_{};
};

} // namespace

FieldData parse_xml_vtk_field(std::string_view bytes, const FieldRequest& request) {
    const Parts parts = split_file(bytes);
    pugi::xml_document document;
    const auto result = document.load_buffer(parts.xml.data(), parts.xml.size());
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (!result) {
        const auto at =
            std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), parts.xml.size());
        const auto line =
            1 + std::count(parts.xml.begin(), parts.xml.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        throw InputError("XML syntax error at line " + std::to_string(line));
    }
    const Node root = document.document_element();
    if (std::string_view(root.name()) != "VTKFile")
        throw InputError("its root element is <" + excerpt(root.name()) + ">, not <VTKFile>");
    return XmlReader(root, parts, request).field();
}

} // namespace gaspard
