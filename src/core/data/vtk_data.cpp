#include "core/data/vtk_data.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/letters.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

struct NamedType {
    std::string_view name;
    VtkType type;
};

constexpr std::array<NamedType, 25> types = {{
    {"float", {true, true, 4}},
    {"double", {true, true, 8}},
    {"char", {false, true, 1}},
    {"signed_char", {false, true, 1}},
    {"unsigned_char", {false, false, 1}},
    {"short", {false, true, 2}},
    {"unsigned_short", {false, false, 2}},
    {"int", {false, true, 4}},
    {"unsigned_int", {false, false, 4}},
    {"long", {false, true, 8}},
    {"unsigned_long", {false, false, 8}},
    {"vtkidtype", {false, true, 4}},
    {"vtktypeint64", {false, true, 8}},
    {"vtktypeuint64", {false, false, 8}},
    {"vtktypeint32", {false, true, 4}},
    {"float32", {true, true, 4}},
    {"float64", {true, true, 8}},
    {"int8", {false, true, 1}},
    {"uint8", {false, false, 1}},
    {"int16", {false, true, 2}},
    {"uint16", {false, false, 2}},
    {"int32", {false, true, 4}},
    {"uint32", {false, false, 4}},
    {"int64", {false, true, 8}},
    {"uint64", {false, false, 8}},
}};

template <class Number, class Bits>
double number_of(std::uint64_t bits) {
    return static_cast<double>(std::bit_cast<Number>(static_cast<Bits>(bits)));
}

double decode(std::uint64_t bits, const VtkType& type) {
    if (type.real)
        return type.bytes == 4 ? number_of<float, std::uint32_t>(bits)
                               : number_of<double, std::uint64_t>(bits);
    if (!type.is_signed) return static_cast<double>(bits);
    switch (type.bytes) {
    case 1:
        return number_of<std::int8_t, std::uint8_t>(bits);
    case 2:
        return number_of<std::int16_t, std::uint16_t>(bits);
    case 4:
        return number_of<std::int32_t, std::uint32_t>(bits);
    default:
        return number_of<std::int64_t, std::uint64_t>(bits);
    }
}

/// One value for each tuple: the number, or the length of the vector.
std::vector<double> lengths(std::vector<double> numbers, std::size_t components) {
    if (components == 1) return numbers;
    std::vector<double> all(numbers.size() / components);
    for (std::size_t i = 0; i < all.size(); ++i) {
        double sum = 0;
        for (std::size_t c = 0; c < components; ++c) {
            const double one = numbers[i * components + c];
            sum += one * one;
        }
        all[i] = std::sqrt(sum);
    }
    return all;
}

std::vector<double> middles(const std::vector<double>& axis) {
    if (axis.size() < 2) return axis;
    std::vector<double> all(axis.size() - 1);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = 0.5 * (axis[i] + axis[i + 1]);
    return all;
}

bool has_three_directions(const std::array<std::vector<double>, 3>& axes) {
    return std::all_of(axes.begin(), axes.end(), [](const auto& axis) { return axis.size() > 1; });
}

/// A plane of a grid: its two longest directions; `level` chooses along the third.
std::variant<GridData, ScatteredData> slice(const std::array<std::vector<double>, 3>& axes,
                                            const std::vector<double>& values, std::int64_t level) {
    std::array<std::size_t, 2> plane = {0, 1};
    if (axes[2].size() > 1 && axes[1].size() < 2)
        plane = {0, 2};
    else if (axes[2].size() > 1 && axes[0].size() < 2)
        plane = {1, 2};
    const std::size_t across = 3 - plane[0] - plane[1];
    if (axes[plane[0]].size() < 2 || axes[plane[1]].size() < 2)
        throw InputError("it must have two values at least along two directions");
    const std::array<std::size_t, 3> strides = {1, axes[0].size(), axes[0].size() * axes[1].size()};
    const std::size_t begin = find_index(level, axes[across].size(), "level") * strides[across];
    GridData grid{Coordinates::cartesian, {axes[plane[0]], axes[plane[1]], {}}, {}};
    grid.values.reserve(grid.axes[0].size() * grid.axes[1].size());
    for (std::size_t j = 0; j < grid.axes[1].size(); ++j)
        for (std::size_t i = 0; i < grid.axes[0].size(); ++i)
            grid.values.push_back(values[begin + i * strides[plane[0]] + j * strides[plane[1]]]);
    return with_sorted_axes(std::move(grid));
}

/// The means of the points of each cell of a structured grid.
std::vector<double> structured_centres(const std::vector<double>& points,
                                       const std::array<std::size_t, 3>& n) {
    std::vector<double> all;
    const auto cells = [&](std::size_t d) { return std::max<std::size_t>(n[d], 2) - 1; };
    for (std::size_t k = 0; k < cells(2); ++k)
        for (std::size_t j = 0; j < cells(1); ++j)
            for (std::size_t i = 0; i < cells(0); ++i)
                for (std::size_t c = 0; c < 3; ++c) {
                    double sum = 0;
                    for (std::size_t corner = 0; corner < 8; ++corner) {
                        const std::size_t ii = std::min(i + (corner & 1), n[0] - 1),
                                          jj = std::min(j + (corner >> 1 & 1), n[1] - 1),
                                          kk = std::min(k + (corner >> 2), n[2] - 1);
                        sum += points[3 * (ii + n[0] * (jj + n[1] * kk)) + c];
                    }
                    all.push_back(sum / 8);
                }
    return all;
}

std::vector<double> cell_centres(const std::vector<double>& points, const VtkCells& cells) {
    std::vector<double> all;
    for (std::size_t c = 0; c + 1 < cells.offsets.size(); ++c) {
        const std::size_t begin = cells.offsets[c], end = cells.offsets[c + 1];
        if (end < begin || end > cells.connectivity.size() || end == begin)
            throw InputError("cell " + std::to_string(c) + " has no points, or wrong offsets");
        std::array<double, 3> sum{};
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t point = cells.connectivity[k];
            if (point >= points.size() / 3)
                throw InputError("cell " + std::to_string(c) + " has a point that does not exist");
            for (std::size_t d = 0; d < 3; ++d) sum[d] += points[3 * point + d];
        }
        for (const double one : sum) all.push_back(one / static_cast<double>(end - begin));
    }
    return all;
}

/// Points of which one coordinate is constant lie in a plane.
ScatteredData at_points(const std::vector<double>& points, std::vector<double> values) {
    ScatteredData data{Coordinates::cartesian, 3, Points(values.size()), std::move(values)};
    for (std::size_t p = 0; p < data.points.size(); ++p)
        data.points.set(p, {points[3 * p], points[3 * p + 1], points[3 * p + 2]});
    const auto flat = [](const std::vector<double>& all) {
        const auto [low, high] = std::minmax_element(all.begin(), all.end());
        return all.empty() || *low == *high;
    };
    if (flat(data.points.z)) {
        data.dimension = 2;
        std::fill(data.points.z.begin(), data.points.z.end(), 0.0);
    }
    return data;
}

std::vector<std::string> names_of(const VtkFile& file) {
    std::vector<std::string> names;
    for (const VtkArray& array : file.arrays) {
        const bool both = std::any_of(file.arrays.begin(), file.arrays.end(), [&](const VtkArray& other) {
            return !other.of_cells && other.name == array.name;
        });
        names.push_back(array.of_cells && both ? array.name + " (cells)" : array.name);
    }
    return names;
}

} // namespace

std::optional<VtkType> vtk_type(std::string_view name) {
    for (const NamedType& one : types)
        if (same_word(one.name, name)) return one.type;
    return std::nullopt;
}

std::optional<double> vtk_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
    if (error == std::errc()) return value;
    const auto exponent = word.find_first_of("eE"); // beyond what a double can hold
    const bool small = exponent == std::string_view::npos ? word.find_first_of("123456789") > word.find('.')
                                                          : word.substr(exponent + 1).starts_with('-');
    return small ? 0 : std::numeric_limits<double>::infinity();
}

std::vector<double> vtk_numbers(std::string_view bytes, const VtkType& type, bool big_endian) {
    std::vector<double> all(bytes.size() / type.bytes);
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < type.bytes; ++k) {
            const std::size_t at = i * type.bytes + (big_endian ? k : type.bytes - 1 - k);
            bits = bits << 8 | static_cast<unsigned char>(bytes[at]);
        }
        all[i] = decode(bits, type);
    }
    return all;
}

std::size_t checked_product(std::size_t a, std::size_t b, std::size_t c, std::string_view what) {
    const auto fits = [](std::size_t m, std::size_t n) { return n == 0 || m <= largest_field / n; };
    if (!fits(a, b) || !fits(a * b, c))
        throw InputError("it has more than " + std::to_string(largest_field) + " " + std::string(what));
    return a * b * c;
}

FieldData vtk_field(const VtkFile& file, const FieldRequest& request) {
    find_time(request, 1);
    if (file.arrays.empty()) throw InputError("it has no arrays of numbers at points or cells");
    FieldData field{{}, names_of(file), {}, {}};
    const std::size_t chosen = find_variable(request.variable, field.variables);
    const VtkArray& array = file.arrays[chosen];
    field.variable = field.variables[chosen];
    std::vector<double> values = lengths(array.read(), array.components);
    if (array.components > 1)
        field.notes.push_back("The value of '" + array.name + "' is the length of its vectors.");
    if (array.of_cells) field.notes.push_back("The values of cells are used at the centres of the cells.");
    const auto demand = [&](std::size_t count) {
        if (values.size() != count)
            throw InputError("'" + array.name + "' has " + std::to_string(values.size()) + " values for " +
                             std::to_string(count) + (array.of_cells ? " cells" : " points"));
    };
    if (file.axes) {
        auto axes = *file.axes;
        if (array.of_cells)
            for (auto& axis : axes) axis = middles(axis);
        demand(checked_product(axes[0].size(), axes[1].size(), axes[2].size(), "points"));
        field.data = request.dimension == 3 && has_three_directions(axes)
                         ? with_sorted_axes({Coordinates::cartesian, axes, std::move(values)})
                         : slice(axes, values, request.level);
        return field;
    }
    find_index(request.level, 1, "level");
    std::vector<double> centres;
    if (array.of_cells && file.structure[0] > 0)
        centres = structured_centres(file.points, file.structure);
    else if (array.of_cells && file.cells)
        centres = cell_centres(file.points, file.cells());
    const std::vector<double>& at = array.of_cells ? centres : file.points;
    demand(at.size() / 3);
    for (const double one : at)
        if (!std::isfinite(one)) throw InputError("a coordinate of a point is not finite");
    field.data = arranged(at_points(at, std::move(values)), field.notes, request);
    return field;
}

} // namespace gaspard
