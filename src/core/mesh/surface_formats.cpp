// OBJ, OFF and STL; PLY has a file of its own.
//
// OpenMesh has readers for all four, but version 9 reads coordinates in single precision, follows the global
// locale (with a decimal comma its PLY reader never ends), opens the material files that an OBJ names, and
// drops or duplicates what is not manifold. These parsers keep every digit and every face.
#include "core/mesh/surface_formats.hpp"

#include "core/mesh/text_scanner.hpp"

#include <array>
#include <bit>
#include <map>

namespace gaspard {

namespace {

Vec3 point_in(std::string_view& rest) {
    Vec3 p;
    for (double* coordinate : {&p.x, &p.y, &p.z}) *coordinate = number_in<double>(next_word(rest));
    return p;
}

/// A corner such as "7", "7/1", "7//3" or "-1", counted from 0.
std::int32_t obj_corner(std::string_view word, std::size_t vertices) {
    const auto number = number_in<std::int32_t>(word.substr(0, word.find('/')));
    if (number > 0) return number - 1;
    if (number == 0) throw InputError("vertices are counted from 1, or from -1 backwards");
    const auto back = std::int64_t{number} + static_cast<std::int64_t>(vertices);
    if (back < 0) throw InputError("vertex " + std::string(word) + " lies before the first one");
    return static_cast<std::int32_t>(back);
}

} // namespace

SurfaceFile parse_obj(std::string_view text) {
    SurfaceFile file{.points = {}, .faces = {}, .base = 1};
    std::vector<std::int32_t> corners;
    Lines lines(text, '#');
    while (lines.next())
        lines.at_line([&] {
            std::string_view rest = lines.line();
            const std::string_view keyword = next_word(rest);
            if (keyword == "v") file.points.push_back(point_in(rest));
            if (keyword != "f") return;
            corners.clear();
            for (auto word = next_word(rest); !word.empty(); word = next_word(rest))
                corners.push_back(obj_corner(word, file.points.size()));
            file.faces.add(corners);
        });
    return file;
}

SurfaceFile parse_off(std::string_view text) {
    SurfaceFile file;
    std::array<std::size_t, 2> counts{}; // vertices and faces
    Lines lines(text, '#');
    if (!lines.next()) throw InputError("it is empty");
    lines.at_line([&] {
        std::string_view rest = lines.line();
        const std::string_view keyword = next_word(rest);
        if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "STOFF" &&
            keyword != "CNOFF")
            throw InputError("an OFF file begins with OFF");
        std::string_view word = next_word(rest);
        if (word.empty() && lines.next()) rest = lines.line(), word = next_word(rest);
        counts[0] = number_in<std::size_t>(word), counts[1] = number_in<std::size_t>(next_word(rest));
    });
    const auto ends_early = [](std::size_t have, std::size_t of, const char* what) {
        throw InputError("it ends after " + std::to_string(have) + " of " + std::to_string(of) + ' ' + what);
    };
    while (file.points.size() < counts[0]) {
        if (!lines.next()) ends_early(file.points.size(), counts[0], "vertices");
        lines.at_line([&] {
            std::string_view rest = lines.line();
            file.points.push_back(point_in(rest));
        });
    }
    std::vector<std::int32_t> corners;
    while (file.faces.size() < counts[1]) {
        if (!lines.next()) ends_early(file.faces.size(), counts[1], "faces");
        lines.at_line([&] {
            std::string_view rest = lines.line();
            corners.clear();
            for (auto n = number_in<std::uint32_t>(next_word(rest)); n > 0; --n)
                corners.push_back(number_in<std::int32_t>(next_word(rest)));
            file.faces.add(corners);
        });
    }
    return file;
}

namespace {

/// Triangles of points, equal points made one.
class Welder {
  public:
    void corner(Vec3 p) {
        // By their bits, after -0 became +0; what is not a number is found later.
        const std::array key = {std::bit_cast<std::uint64_t>(p.x + 0.0),
                                std::bit_cast<std::uint64_t>(p.y + 0.0),
                                std::bit_cast<std::uint64_t>(p.z + 0.0)};
        const auto [entry, fresh] = numbers_.try_emplace(key, static_cast<std::int32_t>(numbers_.size()));
        if (fresh) file_.points.push_back(p);
        triangle_[corners_++] = entry->second;
    }
    void end_triangle() {
        if (corners_ != 3) throw InputError("a facet has " + std::to_string(corners_) + " corners, not 3");
        corners_ = 0;
        const auto [a, b, c] = triangle_;
        if (a != b && b != c && c != a) file_.faces.add(triangle_);
    }
    bool full() const { return corners_ == 3; }
    bool empty() const { return corners_ == 0; }
    SurfaceFile take() { return std::move(file_); }

  private:
    SurfaceFile file_;
    std::map<std::array<std::uint64_t, 3>, std::int32_t> numbers_;
    std::array<std::int32_t, 3> triangle_{};
    std::size_t corners_ = 0;
};

constexpr std::size_t stl_header = 84, stl_triangle = 50; // bytes

std::uint32_t little_endian_word(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << 8 * k;
    return word;
}

SurfaceFile binary_stl(std::string_view bytes) {
    Welder welder;
    const auto coordinate = [&](std::size_t at) {
        return double{std::bit_cast<float>(little_endian_word(bytes, at))};
    };
    for (std::size_t at = stl_header; at + stl_triangle <= bytes.size(); at += stl_triangle) {
        for (std::size_t k = 12; k < 48; k += 12) // a normal comes first
            welder.corner({coordinate(at + k), coordinate(at + k + 4), coordinate(at + k + 8)});
        welder.end_triangle();
    }
    return welder.take();
}

/// The first word of `rest`, in small letters; keywords are at most 40 long.
std::string next_keyword(std::string_view& rest) {
    std::string keyword(next_word(rest).substr(0, 40));
    for (char& c : keyword) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return keyword;
}

SurfaceFile text_stl(std::string_view text) {
    Welder welder;
    Lines lines(text, 0);
    bool ended = false;
    while (lines.next())
        lines.at_line([&] {
            std::string_view rest = lines.line();
            const std::string keyword = next_keyword(rest);
            ended = keyword == "endsolid";
            if (keyword == "vertex") {
                if (welder.full()) throw InputError("a facet has more than 3 corners");
                welder.corner(point_in(rest));
            } else if (keyword == "endloop") {
                welder.end_triangle();
            } else if (keyword != "solid" && keyword != "facet" && keyword != "outer" &&
                       keyword != "endfacet" && keyword != "endsolid") {
                throw InputError("'" + keyword + "' is no keyword of STL");
            }
        });
    if (!welder.empty() || !ended) throw InputError("it ends before endsolid");
    return welder.take();
}

/// Binary files may begin with "solid" as well, so the size decides.
bool is_binary_stl(std::string_view bytes) {
    return bytes.size() >= stl_header &&
           bytes.size() == stl_header + std::size_t{little_endian_word(bytes, 80)} * stl_triangle;
}

bool is_text_stl(std::string_view bytes) { return next_keyword(bytes) == "solid"; }

} // namespace

bool is_stl(std::string_view bytes) { return is_binary_stl(bytes) || is_text_stl(bytes); }

SurfaceFile parse_stl(std::string_view bytes) {
    if (is_binary_stl(bytes)) return binary_stl(bytes);
    if (is_text_stl(bytes)) return text_stl(bytes);
    throw InputError("it is neither a text STL file, which begins with solid, nor a binary one of the size "
                     "that its number of triangles gives");
}

} // namespace gaspard
