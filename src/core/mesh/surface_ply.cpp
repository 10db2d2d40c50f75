// PLY: a header that describes elements and their properties, then the elements as text or binary.
#include "core/mesh/surface_formats.hpp"
#include "core/mesh/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

namespace gaspard {

namespace {

struct ScalarType {
    std::string_view name, other_name;
    std::size_t bytes;
    enum Kind { is_signed, is_unsigned, real } kind;
};
constexpr std::array scalar_types = {
    ScalarType{"char", "int8", 1, ScalarType::is_signed},
    ScalarType{"uchar", "uint8", 1, ScalarType::is_unsigned},
    ScalarType{"short", "int16", 2, ScalarType::is_signed},
    ScalarType{"ushort", "uint16", 2, ScalarType::is_unsigned},
    ScalarType{"int", "int32", 4, ScalarType::is_signed},
    ScalarType{"uint", "uint32", 4, ScalarType::is_unsigned},
    ScalarType{"float", "float32", 4, ScalarType::real},
    ScalarType{"double", "float64", 8, ScalarType::real},
};

const ScalarType& scalar_type(std::string_view name) {
    for (const ScalarType& type : scalar_types)
        if (name == type.name || name == type.other_name) return type;
    throw InputError("'" + std::string(name.substr(0, 40)) + "' is no type of PLY");
}

struct Property {
    std::string_view name;
    ScalarType type;
    std::optional<ScalarType> count_type; ///< of a list
};
struct Element {
    std::string_view name;
    std::size_t count = 0;
    std::vector<Property> properties;
};
enum class Encoding { text, little_endian, big_endian };

struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
};

Encoding encoding_of(std::string_view name) {
    if (name == "ascii") return Encoding::text;
    if (name == "binary_little_endian") return Encoding::little_endian;
    if (name == "binary_big_endian") return Encoding::big_endian;
    throw InputError("'" + std::string(name.substr(0, 40)) + "' is no encoding of PLY");
}

void parse_header_line(std::string_view rest, Header& header) {
    const std::string_view keyword = next_word(rest);
    if (keyword == "format") header.encoding = encoding_of(next_word(rest));
    if (keyword == "element") {
        const std::string_view name = next_word(rest);
        header.elements.push_back({name, number_in<std::size_t>(next_word(rest)), {}});
    }
    if (keyword != "property") return;
    if (header.elements.empty()) throw InputError("a property comes before the first element");
    Property property;
    std::string_view type = next_word(rest);
    if (type == "list") {
        property.count_type = scalar_type(next_word(rest));
        if (property.count_type->kind == ScalarType::real)
            throw InputError("the length of a list has to be an integer");
        type = next_word(rest);
    }
    property.type = scalar_type(type);
    property.name = next_word(rest);
    header.elements.back().properties.push_back(property);
}

/// `bytes` becomes what follows the header.
Header parse_header(std::string_view& bytes) {
    Header header;
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const auto end = std::min(bytes.find('\n'), bytes.size());
        std::string_view line = bytes.substr(0, end);
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
        std::string_view rest = line;
        const std::string_view keyword = next_word(rest);
        if (number == 1 && keyword != "ply") throw InputError("a PLY file begins with ply");
        if (keyword == "end_header") return header;
        try {
            parse_header_line(line, header);
        } catch (const InputError& error) {
            throw InputError("line " + std::to_string(number) + ": " + error.what());
        }
    }
    throw InputError("its header does not end");
}

/// Numbers of the body, one after another.
class Body {
  public:
    Body(std::string_view bytes, Encoding encoding) : rest_(bytes), encoding_(encoding) {}

    double next(const ScalarType& type) {
        if (encoding_ == Encoding::text) {
            const std::string_view word = next_word(rest_);
            if (word.empty()) throw InputError("it ends too early");
            return number_in<double>(word);
        }
        if (rest_.size() < type.bytes) throw InputError("it ends too early");
        std::uint64_t word = 0;
        for (std::size_t k = 0; k < type.bytes; ++k) {
            const std::size_t from_low = encoding_ == Encoding::little_endian ? k : type.bytes - 1 - k;
            word |= std::uint64_t{static_cast<unsigned char>(rest_[k])} << 8 * from_low;
        }
        rest_.remove_prefix(type.bytes);
        return value_of(word, type);
    }

    std::size_t length(const ScalarType& type) {
        const double n = next(type);
        if (!(n >= 0 && n <= 1e9) || n != static_cast<double>(static_cast<std::size_t>(n)))
            throw InputError("a list has an impossible length");
        return static_cast<std::size_t>(n);
    }

  private:
    static double value_of(std::uint64_t word, const ScalarType& type) {
        if (type.kind == ScalarType::real)
            return type.bytes == 8 ? std::bit_cast<double>(word)
                                   : double{std::bit_cast<float>(static_cast<std::uint32_t>(word))};
        const auto value = static_cast<std::int64_t>(word);
        const std::int64_t limit = std::int64_t{1} << (8 * type.bytes - 1);
        const bool negative = type.kind == ScalarType::is_signed && value >= limit;
        return static_cast<double>(negative ? value - 2 * limit : value);
    }

    std::string_view rest_;
    Encoding encoding_;
};

std::int32_t vertex_number(double value) {
    constexpr double limit = 2147483648.0;
    if (!(value >= -limit && value < limit) || value != static_cast<double>(static_cast<std::int32_t>(value)))
        throw InputError("a face has a vertex number that is no integer of 32 bits");
    return static_cast<std::int32_t>(value);
}

void parse_vertex(const Element& element, Body& body, SurfaceFile& file) {
    Vec3 p;
    for (const Property& property : element.properties) {
        const std::size_t count = property.count_type ? body.length(*property.count_type) : 1;
        for (std::size_t i = 0; i < count; ++i) {
            const double value = body.next(property.type);
            if (property.count_type) continue;
            if (property.name == "x") p.x = value;
            if (property.name == "y") p.y = value;
            if (property.name == "z") p.z = value;
        }
    }
    file.points.push_back(p);
}

bool names_vertices(const Property& property) {
    return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void parse_face(const Element& element, Body& body, SurfaceFile& file, std::vector<std::int32_t>& corners) {
    corners.clear();
    for (const Property& property : element.properties) {
        const std::size_t count = property.count_type ? body.length(*property.count_type) : 1;
        for (std::size_t i = 0; i < count; ++i) {
            const double value = body.next(property.type);
            if (names_vertices(property)) corners.push_back(vertex_number(value));
        }
    }
    file.faces.add(corners);
}

void skip(const Element& element, Body& body) {
    for (const Property& property : element.properties) {
        const std::size_t count = property.count_type ? body.length(*property.count_type) : 1;
        for (std::size_t i = 0; i < count; ++i) body.next(property.type);
    }
}

void check_element(const Element& element) {
    const auto has = [&](std::string_view name) {
        for (const Property& p : element.properties)
            if (p.name == name && !p.count_type) return true;
        return false;
    };
    if (element.name == "vertex" && !(has("x") && has("y") && has("z")))
        throw InputError("its vertices lack x, y or z");
    bool names = false;
    for (const Property& p : element.properties) names |= names_vertices(p);
    if (element.name == "face" && !names) throw InputError("its faces lack a list vertex_indices");
}

} // namespace

SurfaceFile parse_ply(std::string_view bytes) {
    const Header header = parse_header(bytes);
    Body body(bytes, header.encoding);
    SurfaceFile file;
    std::vector<std::int32_t> corners;
    for (const Element& element : header.elements) {
        check_element(element);
        if (element.properties.empty()) continue; // takes no bytes, however many there are
        for (std::size_t i = 0; i < element.count; ++i) {
            if (element.name == "vertex")
                parse_vertex(element, body, file);
            else if (element.name == "face")
                parse_face(element, body, file, corners);
            else
                skip(element, body);
        }
    }
    return file;
}

} // namespace gaspard
