#include "core/spline/patch_text.hpp"

#include "core/base/number_text.hpp"
#include "core/spline/patch_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t most_points = std::size_t{1} << 22; // of one patch; the files are limited, too

/// The words of a text without comments, which reach from # to the end of the line.
class Words {
  public:
    Words(std::string_view text, std::string origin) : text_(text), origin_(std::move(origin)) {}

    /// What messages call the place from here on.
    void set_origin(std::string origin) { origin_ = std::move(origin); }
    bool at_end() { return peek().empty(); }
    /// The next word; empty at the end.
    std::string_view peek() {
        constexpr std::string_view blanks = " \t\r\n\f\v";
        while (true) {
            text_.remove_prefix(std::min(text_.find_first_not_of(blanks), text_.size()));
            if (!text_.starts_with('#')) break;
            text_.remove_prefix(std::min(text_.find('\n'), text_.size()));
        }
        return text_.substr(0, std::min(text_.find_first_of(" \t\r\n\f\v#"), text_.size()));
    }
    std::string_view word() {
        const std::string_view next = peek();
        text_.remove_prefix(next.size());
        return next;
    }
    void skip_line() { text_.remove_prefix(std::min(text_.find('\n'), text_.size())); }
    double number(const std::string& what) {
        const std::string_view next = word();
        const auto value = parse_number(next);
        if (!value)
            not_a_patch(origin_, what + " must be a number, but " +
                                     (next.empty() ? "the file ends"
                                                   : "is '" + std::string(next.substr(0, 40)) + "'"));
        return *value;
    }
    std::vector<double> numbers(std::size_t count, const std::string& what) {
        std::vector<double> all;
        for (std::size_t i = 0; i < count; ++i) all.push_back(number(what));
        return all;
    }
    /// An integer from 0 to `most`.
    std::size_t count(const std::string& what, std::size_t most) {
        const double value = number(what);
        if (!(value >= 0 && value <= static_cast<double>(most)) || value != std::floor(value))
            not_a_patch(origin_, what + " must be an integer from 0 to " + std::to_string(most));
        return static_cast<std::size_t>(value);
    }
    /// Reads up to and including a word; false at the end.
    bool find(std::string_view wanted) {
        while (!at_end())
            if (word() == wanted) return true;
        return false;
    }
    void expect(std::string_view wanted) {
        if (word() != wanted) not_a_patch(origin_, "'" + std::string(wanted) + "' is missing");
    }

  private:
    std::string_view text_;
    std::string origin_;
};

/// A patch as the file has it, not yet checked, so that an invalid one does not refuse the others.
struct Unchecked {
    PatchParts parts;
    bool homogeneous = true; ///< its points are multiplied by their weights
};

FoundPatch choose(std::vector<Unchecked> all, const std::string& kind, const PatchText& file) {
    const ChosenPatch chosen =
        choose_patch(std::vector<PatchEntry>(all.size(), PatchEntry{kind, {}, {}}), file);
    auto& [parts, homogeneous] = all[chosen.entry];
    if (homogeneous) divide_by_weights(parts, chosen.origin);
    return {make_patch(std::move(parts), chosen.origin), chosen.origin, chosen.patches};
}

/// For errors after which the next patch cannot be found.
std::string origin_of_patch(const PatchText& file, std::size_t index) {
    return file.origin + ", patch " + std::to_string(index + 1) + ",";
}

/// "degree count knots", twice; returns the number of control points along each direction.
std::array<std::size_t, 2> mfem_knots(Words& words, PatchParts& parts) {
    std::array<std::size_t, 2> size{};
    for (std::size_t d = 0; d < 2; ++d) {
        const std::size_t degree = words.count("a degree", 100);
        size[d] = words.count("the number of control points", most_points);
        parts.degrees[d] = static_cast<double>(degree);
        parts.knots[d] = words.numbers(size[d] + degree + 1, "a knot");
    }
    return size;
}

Unchecked mfem_patch(Words& words, const std::string& origin) {
    words.expect("knotvectors");
    if (words.count("the number of knot vectors", 3) != 2)
        cannot_read(origin, "its patches are not surfaces");
    PatchParts parts;
    const auto size = mfem_knots(words, parts);
    words.expect("dimension");
    const std::size_t dimension = words.count("the dimension", 3);
    if (dimension < 2) not_a_patch(origin, "the dimension must be 2 or 3");
    const std::string kind(words.word());
    const bool homogeneous = kind == "controlpoints" || kind == "controlpoints_homogeneous";
    if (!homogeneous && kind != "controlpoints_cartesian") not_a_patch(origin, "'controlpoints' is missing");
    const std::size_t n = size[0] * size[1];
    if (n > most_points) not_a_patch(origin, "it has too many control points");
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < dimension; ++c) coordinates.push_back(words.number("a coordinate"));
        parts.weights.push_back(words.number("a weight"));
    }
    parts.control = points_in_rows(coordinates, dimension);
    return {std::move(parts), homogeneous};
}

} // namespace

FoundPatch read_mfem(const PatchText& file) {
    Words words(file.text, file.origin);
    words.skip_line();
    if (!words.find("dimension") || words.number("the dimension") != 2)
        cannot_read(file.origin, "it is an MFEM mesh that is not of dimension 2");
    if (!words.find("elements")) not_a_patch(file.origin, "'elements' is missing");
    const std::size_t elements = words.count("the number of elements", most_points);
    if (!words.find("patches"))
        cannot_read(file.origin,
                    "it is an MFEM NURBS mesh without a section 'patches': its control points are "
                    "numbered by a finite element space; write it with 'patches'");
    std::vector<Unchecked> all;
    while (!words.at_end()) {
        const std::string origin = origin_of_patch(file, all.size());
        words.set_origin(origin);
        all.push_back(mfem_patch(words, origin));
    }
    if (all.size() != elements)
        not_a_patch(file.origin, "it says that it has " + std::to_string(elements) +
                                     " elements, each of which is a patch, but there are " +
                                     std::to_string(all.size()) + " patches");
    return choose(std::move(all), "MFEM patch", file);
}

FoundPatch read_geopdes(const PatchText& file) {
    const std::string_view head = file.text.substr(0, std::min(file.text.find('\n'), file.text.size()));
    const bool with_space = head.find("v.2") != std::string_view::npos;
    Words words(file.text, file.origin);
    const std::size_t directions = words.count("the dimension", 3);
    if (directions != 2)
        cannot_read(file.origin, directions == 3 ? "it is a GeoPDEs geometry of solids, not surfaces"
                                                 : "it is a GeoPDEs geometry of curves, not surfaces");
    const std::size_t dimension = with_space ? words.count("the dimension of the space", 3) : directions;
    if (dimension < 2) cannot_read(file.origin, "its surfaces are in a space of fewer than two dimensions");
    const std::size_t patches = words.count("the number of patches", 100000);
    words.skip_line(); // numbers of interfaces and subdomains
    std::vector<Unchecked> all;
    for (std::size_t k = 0; k < patches; ++k) {
        const std::string origin = origin_of_patch(file, k);
        words.set_origin(origin);
        if (!parse_number(words.peek())) words.skip_line(); // its name
        PatchParts parts;
        std::array<std::size_t, 2> size{};
        for (std::size_t d = 0; d < 2; ++d)
            parts.degrees[d] = static_cast<double>(words.count("a degree", 100));
        for (std::size_t& one : size) one = words.count("a number of control points", most_points);
        for (std::size_t d = 0; d < 2; ++d)
            parts.knots[d] =
                words.numbers(size[d] + static_cast<std::size_t>(parts.degrees[d]) + 1, "a knot");
        const std::size_t n = size[0] * size[1];
        if (n > most_points) not_a_patch(origin, "it has too many control points");
        parts.control = points_in_columns(words.numbers(dimension * n, "a coordinate"), dimension);
        parts.weights = words.numbers(n, "a weight");
        all.push_back({std::move(parts)});
    }
    return choose(std::move(all), "GeoPDEs patch", file);
}

} // namespace gaspard
