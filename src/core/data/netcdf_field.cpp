// One variable of a NetCDF file by the CF conventions (cfconventions.org): which dimensions are x and y, time
// and level, follows from coordinate variables (axis, standard_name, units) or else from names and the order.
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/letters.hpp"
#include "core/data/field_file.hpp"
#include "core/data/netcdf_input.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace gaspard {

namespace {

using Variable = NetcdfInputVariable;

enum class Axis { x, y, z, time, unknown };

bool any_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_longitude(const NetcdfInput& file, const Variable& variable) {
    return file.text(variable, "standard_name") == "longitude" ||
           any_of(lower_case(file.text(variable, "units")),
                  {"degrees_east", "degree_east", "degrees_e", "degree_e", "degreese", "degreee"});
}

bool is_latitude(const NetcdfInput& file, const Variable& variable) {
    return file.text(variable, "standard_name") == "latitude" ||
           any_of(lower_case(file.text(variable, "units")),
                  {"degrees_north", "degree_north", "degrees_n", "degree_n", "degreesn", "degreen"});
}

bool is_geographic_name(std::string_view name) {
    return any_of(name, {"lon", "longitude", "nav_lon", "lat", "latitude", "nav_lat"});
}

Axis axis_of_name(std::string_view name) {
    if (any_of(name, {"x", "lon", "longitude", "nlon", "rlon", "xc", "easting", "nav_lon"})) return Axis::x;
    if (any_of(name, {"y", "lat", "latitude", "nlat", "rlat", "yc", "northing", "nav_lat"})) return Axis::y;
    if (any_of(name, {"t", "time", "date"})) return Axis::time;
    if (any_of(name, {"z", "lev", "level", "depth", "height", "plev", "altitude", "isobaric"}))
        return Axis::z;
    return Axis::unknown;
}

/// The axis that a variable with coordinates describes.
Axis axis_of_variable(const NetcdfInput& file, const Variable& variable) {
    if (is_longitude(file, variable)) return Axis::x;
    if (is_latitude(file, variable)) return Axis::y;
    const std::string axis = file.text(variable, "axis"), standard = file.text(variable, "standard_name");
    if (axis == "X" || standard.ends_with("x_coordinate")) return Axis::x;
    if (axis == "Y" || standard.ends_with("y_coordinate")) return Axis::y;
    if (axis == "Z" || !file.text(variable, "positive").empty()) return Axis::z;
    if (axis == "T" || standard == "time" ||
        file.text(variable, "units").find(" since ") != std::string::npos)
        return Axis::time;
    return axis_of_name(lower_case(variable.name));
}

const Variable* coordinate_variable(const NetcdfInput& file, int dimension) {
    const Variable* found = file.find(file.dimensions()[static_cast<std::size_t>(dimension)].name);
    return found != nullptr && found->dimensions == std::vector{dimension} ? found : nullptr;
}

Axis axis_of_dimension(const NetcdfInput& file, int dimension) {
    if (const Variable* variable = coordinate_variable(file, dimension))
        return axis_of_variable(file, *variable);
    return axis_of_name(lower_case(file.dimensions()[static_cast<std::size_t>(dimension)].name));
}

std::vector<std::string> words_in(const std::string& text) {
    std::vector<std::string> words;
    for (const auto part : split(text, " "))
        if (!part.empty()) words.emplace_back(part);
    return words;
}

/// Variables with the coordinates of points along the same dimensions, from the attribute `coordinates`.
struct PointCoordinates {
    const Variable *x = nullptr, *y = nullptr, *z = nullptr;
    bool geographic = false;
};

PointCoordinates point_coordinates(const NetcdfInput& file, const Variable& variable) {
    PointCoordinates found;
    for (const std::string& name : words_in(file.text(variable, "coordinates"))) {
        const Variable* one = file.find(name);
        if (one == nullptr || one->dimensions.empty() || one->dimensions.size() > 2 ||
            one->dimensions.size() > variable.dimensions.size() ||
            !std::equal(one->dimensions.rbegin(), one->dimensions.rend(), variable.dimensions.rbegin()))
            continue;
        const auto underscore = name.rfind('_'); // mesh_node_x
        Axis axis = axis_of_variable(file, *one);
        if (axis == Axis::unknown && underscore != std::string::npos)
            axis = axis_of_name(lower_case(name.substr(underscore + 1)));
        if (axis == Axis::x) found.x = one;
        if (axis == Axis::y) found.y = one;
        if (axis == Axis::z) found.z = one;
        found.geographic = found.geographic || is_longitude(file, *one);
    }
    if (found.x == nullptr || found.y == nullptr || found.x->dimensions != found.y->dimensions) return {};
    if (found.geographic || (found.z != nullptr && found.z->dimensions != found.x->dimensions))
        found.z = nullptr;
    return found;
}

/// Variables that describe others: coordinates, bounds, connectivity, masks.
std::set<std::string> descriptions(const NetcdfInput& file) {
    std::set<std::string> names;
    for (const Variable& variable : file.variables()) {
        for (const char* attribute : {"bounds", "coordinates", "climatology", "grid_mapping"})
            for (const std::string& name : words_in(file.text(variable, attribute))) names.insert(name);
        if (!file.text(variable, "cf_role").empty() ||
            (variable.dimensions.size() == 1 &&
             coordinate_variable(file, variable.dimensions[0]) == &variable))
            names.insert(variable.name);
    }
    return names;
}

const std::string& name_of(const NetcdfInput& file, const Variable& variable, std::size_t d) {
    return file.dimensions()[static_cast<std::size_t>(variable.dimensions[d])].name;
}

std::size_t long_dimensions(const NetcdfInput& file, const Variable& variable) {
    std::size_t count = 0;
    for (std::size_t d = 0; d < variable.dimensions.size(); ++d)
        count += file.length(variable, d) > 1 ? 1 : 0;
    return count;
}

std::vector<std::string> field_names(const NetcdfInput& file) {
    const std::set<std::string> others = descriptions(file);
    std::vector<std::string> names;
    for (const Variable& variable : file.variables())
        if (!others.contains(variable.name) &&
            (long_dimensions(file, variable) >= 2 || point_coordinates(file, variable).x != nullptr))
            names.push_back(variable.name);
    if (!names.empty()) return names;
    if (const auto groups = file.groups(); !groups.empty())
        throw InputError("it has no variable with two dimensions outside of its groups (" +
                         join(groups, ", ").substr(0, 400) +
                         "), which are not read; take them out of the groups (ncks -G :)");
    std::vector<std::string> all;
    for (const Variable& variable : file.variables()) all.push_back(variable.name);
    throw InputError("it has no variable with two dimensions" +
                     (all.empty() ? "" : "; its variables are " + join(all, ", ").substr(0, 400)));
}

/// A part of a variable: one time and level, everything along `free` dimensions.
class Slice {
  public:
    Slice(const NetcdfInput& file, const Variable& variable, const std::vector<std::size_t>& free,
          const FieldRequest& request, FieldData& field)
        : start(variable.dimensions.size(), 0), count(variable.dimensions.size(), 1) {
        std::vector<std::size_t> others;
        for (std::size_t d = 0; d < start.size(); ++d) {
            const std::size_t length = file.length(variable, d);
            if (length == 0)
                throw InputError("'" + variable.name + "' is empty along '" + name_of(file, variable, d) +
                                 "'");
            if (std::find(free.begin(), free.end(), d) == free.end())
                others.push_back(d);
            else
                count[d] = length;
        }
        const auto axis = [&](std::size_t d) { return axis_of_dimension(file, variable.dimensions[d]); };
        const auto take = [&](const auto& suits) {
            const auto found = std::find_if(others.begin(), others.end(), suits);
            if (found == others.end()) return std::optional<std::size_t>();
            const std::size_t d = *found;
            others.erase(found);
            return std::optional(d);
        };
        const auto time = take([&](std::size_t d) { return axis(d) == Axis::time; });
        std::erase_if(others, [&](std::size_t d) { return file.length(variable, d) == 1; });
        auto level = take([&](std::size_t d) { return axis(d) == Axis::z; });
        if (!level && request.dimension == 2) level = take([](std::size_t) { return true; });
        field.time_steps = time ? file.length(variable, *time) : 1;
        const std::size_t step = find_time(request, field.time_steps),
                          height =
                              find_index(request.level, level ? file.length(variable, *level) : 1, "level");
        if (time) start[*time] = step;
        if (level) start[*level] = height;
        const auto entries = [&](std::size_t d) {
            return std::to_string(file.length(variable, d)) + " entries";
        };
        if (level && axis(*level) != Axis::z)
            field.notes.push_back("The dimension " + name_of(file, variable, *level) +
                                  " is no height; level = " + std::to_string(height) +
                                  " chooses one of its " + entries(*level) + ".");
        for (const std::size_t d : others)
            field.notes.push_back("Of the dimension " + name_of(file, variable, d) + " the first of " +
                                  entries(d) + " is used.");
    }

    std::vector<std::size_t> start, count;
};

ScatteredData read_points(const NetcdfInput& file, const Variable& variable, const PointCoordinates& at,
                          const FieldRequest& request, FieldData& field) {
    std::vector<std::size_t> free;
    for (std::size_t d = variable.dimensions.size() - at.x->dimensions.size(); d < variable.dimensions.size();
         ++d)
        free.push_back(d);
    const Slice slice(file, variable, free, request, field);
    ScatteredData data{at.geographic ? Coordinates::geographic : Coordinates::cartesian,
                       at.z != nullptr ? 3 : 2,
                       {},
                       file.values(variable, slice.start, slice.count)};
    data.points.x = file.values(*at.x), data.points.y = file.values(*at.y);
    data.points.z = at.z != nullptr ? file.values(*at.z) : std::vector<double>(data.values.size(), 0);
    if (data.points.x.size() != data.values.size() || data.points.y.size() != data.values.size())
        throw InputError("'" + variable.name + "' has not as many values as coordinates");
    return data;
}

std::vector<double> axis_values(const NetcdfInput& file, const Variable& variable, std::size_t d) {
    if (const Variable* axis = coordinate_variable(file, variable.dimensions[d])) return file.values(*axis);
    std::vector<double> counted(file.length(variable, d));
    for (std::size_t i = 0; i < counted.size(); ++i) counted[i] = static_cast<double>(i);
    return counted;
}

/// Which dimensions of the variable are x and y.
std::array<std::size_t, 2> plane_of(const NetcdfInput& file, const Variable& variable) {
    const std::size_t rank = variable.dimensions.size();
    std::array<std::size_t, 2> found = {rank, rank};
    for (std::size_t d = 0; d < rank; ++d) {
        const Axis axis = axis_of_dimension(file, variable.dimensions[d]);
        if (axis == Axis::x) found[0] = d;
        if (axis == Axis::y) found[1] = d;
    }
    for (std::size_t& one : found) // the others are the last ones, x before y
        for (std::size_t d = rank; one == rank && d-- > 0;)
            if (d != found[0] && d != found[1] && file.length(variable, d) > 1 &&
                axis_of_dimension(file, variable.dimensions[d]) != Axis::time)
                one = d;
    if (found[0] == rank || found[1] == rank)
        throw InputError("'" + variable.name + "' has no two dimensions in space");
    for (const std::size_t d : found)
        if (file.length(variable, d) < 2)
            throw InputError("'" + variable.name + "' has only " + std::to_string(file.length(variable, d)) +
                             " value along '" + name_of(file, variable, d) + "'");
    return found;
}

/// The third dimension in space, beside x and y: z, else the last that is left; nullopt if there is none.
std::optional<std::size_t> height_of(const NetcdfInput& file, const Variable& variable,
                                     const std::array<std::size_t, 2>& plane) {
    std::optional<std::size_t> found;
    for (std::size_t d = variable.dimensions.size(); d-- > 0;) {
        const Axis axis = axis_of_dimension(file, variable.dimensions[d]);
        if (d == plane[0] || d == plane[1] || axis == Axis::time || file.length(variable, d) < 2) continue;
        if (axis == Axis::z) return d;
        if (!found) found = d;
    }
    return found;
}

/// The dimensions of the variable in space: x and y, and z if the request has three and the variable, too.
std::vector<std::size_t> directions_of(const NetcdfInput& file, const Variable& variable,
                                       std::size_t dimension) {
    const std::array<std::size_t, 2> plane = plane_of(file, variable);
    std::vector<std::size_t> found(plane.begin(), plane.end());
    if (dimension == 3)
        if (const auto height = height_of(file, variable, plane)) found.push_back(*height);
    return found;
}

Coordinates kind_of_axes(const NetcdfInput& file, const Variable& variable,
                         const std::vector<std::size_t>& directions) {
    const auto has_coordinates = [&](std::size_t d) {
        return coordinate_variable(file, variable.dimensions[d]) != nullptr;
    };
    if (!std::all_of(directions.begin(), directions.end(), has_coordinates)) return Coordinates::none;
    const Variable *x = coordinate_variable(file, variable.dimensions[directions[0]]),
                   *y = coordinate_variable(file, variable.dimensions[directions[1]]);
    const bool geographic =
        (is_longitude(file, *x) && is_latitude(file, *y)) ||
        (is_geographic_name(lower_case(x->name)) && is_geographic_name(lower_case(y->name)));
    return geographic ? Coordinates::geographic : Coordinates::cartesian;
}

/// From the order of the file, whose last dimension runs fastest.
void put_x_first(GridData& grid, const std::vector<std::size_t>& directions) {
    if (std::is_sorted(directions.rbegin(), directions.rend())) return;
    std::array<std::size_t, 3> strides{};
    for (std::size_t d = 0; d < directions.size(); ++d) {
        strides[d] = 1;
        for (std::size_t other = 0; other < directions.size(); ++other)
            if (directions[other] > directions[d]) strides[d] *= grid.count(other);
    }
    std::vector<double> turned;
    turned.reserve(grid.values.size());
    for (std::size_t k = 0; k < grid.count(2); ++k)
        for (std::size_t j = 0; j < grid.count(1); ++j)
            for (std::size_t i = 0; i < grid.count(0); ++i)
                turned.push_back(grid.values[i * strides[0] + j * strides[1] + k * strides[2]]);
    grid.values = std::move(turned);
}

GridData read_grid(const NetcdfInput& file, const Variable& variable, const FieldRequest& request,
                   FieldData& field) {
    const auto directions = directions_of(file, variable, request.dimension);
    const bool chosen = long_dimensions(file, variable) > directions.size();
    for (std::size_t k = 0; k < directions.size(); ++k)
        if ((chosen || k == 2) &&
            axis_of_dimension(file, variable.dimensions[directions[k]]) == Axis::unknown)
            field.notes.push_back("The dimension " + name_of(file, variable, directions[k]) +
                                  " is no known axis and is taken as " + "xyz"[k] + ".");
    const Slice slice(file, variable, directions, request, field);
    // The values first: they check that the lengths are not those of a damaged header.
    GridData grid{
        kind_of_axes(file, variable, directions), {}, file.values(variable, slice.start, slice.count)};
    for (std::size_t d = 0; d < directions.size(); ++d)
        grid.axes[d] = axis_values(file, variable, directions[d]);
    put_x_first(grid, directions);
    return with_sorted_axes(std::move(grid));
}

/// Leaves the variables with three directions or coordinates in space if there are any, and the wanted one is
/// none of the others.
void prefer_solid_fields(const NetcdfInput& file, const std::string& wanted,
                         std::vector<std::string>& names) {
    std::vector<std::string> in_space;
    for (const std::string& name : names) {
        const Variable& variable = *file.find(name);
        const PointCoordinates at = point_coordinates(file, variable);
        const bool grid = at.x == nullptr && long_dimensions(file, variable) >= 3;
        if (at.z != nullptr || (grid && directions_of(file, variable, 3).size() == 3))
            in_space.push_back(name);
    }
    const bool fits = wanted.empty() || std::find(in_space.begin(), in_space.end(), wanted) != in_space.end();
    if (!in_space.empty() && fits) names = std::move(in_space);
}

} // namespace

FieldData parse_netcdf_field(std::string_view bytes, const FieldRequest& request) {
    const NetcdfInput file(bytes);
    FieldData field;
    field.variables = field_names(file);
    if (request.dimension == 3) prefer_solid_fields(file, request.variable, field.variables);
    field.variable = field.variables[find_variable(request.variable, field.variables)];
    const Variable& variable = *file.find(field.variable);
    const PointCoordinates at = point_coordinates(file, variable);
    if (at.x == nullptr)
        field.data = read_grid(file, variable, request, field);
    else
        field.data = arranged(read_points(file, variable, at, request, field), field.notes, request);
    return field;
}

} // namespace gaspard
