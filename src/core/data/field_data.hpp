// A scalar field of a file as plain data: values on a rectilinear grid or at scattered points. What the
// values are for, and where they lie in a domain, is not decided here.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gaspard GASPARD_API {

/// The largest number of values (of one variable, at one time and level) and of points that is read: 32 Mi.
/// Readers refuse more before they allocate memory for them.
inline constexpr std::size_t largest_field = std::size_t{1} << 25;

enum class Coordinates {
    none,       ///< rows and columns of a table; (0, 0) is its lower left entry
    cartesian,  ///< x, y (and z)
    geographic, ///< longitude and latitude in degrees, in this order
};

/// Values at (axes[0][i], axes[1][j], axes[2][k]), the first direction fastest. Axes increase strictly.
struct GridData {
    Coordinates coordinates = Coordinates::none;
    std::array<std::vector<double>, 3> axes; ///< the third is empty if the grid has two directions
    std::vector<double> values;              ///< NaN where a value is missing

    std::size_t dimension() const { return axes[2].empty() ? 2 : 3; }
    /// Points along a direction; 1 along the third of a grid in the plane.
    std::size_t count(std::size_t d) const { return axes[d].empty() ? 1 : axes[d].size(); }
};

struct ScatteredData {
    Coordinates coordinates = Coordinates::cartesian;
    int dimension = 2;          ///< 3: z is used
    Points points;              ///< geographic: x is the longitude, y the latitude
    std::vector<double> values; ///< NaN where a value is missing
};

/// What to read of a file.
struct FieldRequest {
    std::string variable{};                 ///< empty: the first
    std::int64_t time = 0;                  ///< index of the step, from 0; -1 is the last
    std::int64_t level = 0;                 ///< likewise
    std::function<void(double)> progress{}; ///< told the fraction of a long text that is read
    std::stop_token stop{};
    /// 3: grids with three directions are read whole, and `level` is not used; others are as for 2.
    std::size_t dimension = 2;
    bool time_ends = true; ///< false: after the last step it goes on as it is
};
/// " in time step 3 (the first is 0)", for messages.
std::string in_step(std::int64_t step);
/// For loops over long data: reports progress; throws Interrupted if asked to stop.
void check_stop(const FieldRequest& request, double done);

struct FieldData {
    std::string variable;               ///< the name of what was read
    std::vector<std::string> variables; ///< all that can be read
    std::variant<GridData, ScatteredData> data;
    std::size_t time_steps = 1;       ///< of the variable in the file
    std::vector<std::string> notes{}; ///< sentences about the choices that the reader made
};

/// Missing values are NaN.
std::size_t count_missing(const std::vector<double>& values);
const std::vector<double>& values_of(const FieldData& field);

/// Points whose coordinates differ by less than about 1e-9 of the extent along each axis become one,
/// the first of them, with the mean of their values. Returns how many points it removed.
std::size_t merge_coincident(Points& points, std::vector<double>& values, const std::stop_token& stop = {});
/// "2 points coincide with others; ...".
std::string coincidence_note(std::size_t merged);

/// The same data as a grid if its points, in the plane or in space, are all points of a rectilinear grid, in
/// any order. Coordinates that differ by less than 1e-9 of the extent are the same.
std::optional<GridData> as_grid(const ScatteredData& data);
/// The data without coincident points, which a note counts, as a grid if they are one with at most so many
/// directions as the request has.
std::variant<GridData, ScatteredData> arranged(ScatteredData data, std::vector<std::string>& notes,
                                               const FieldRequest& request = {});
/// Sorts the axes of a grid, and its values with them. Throws InputError (without a file's name) if a
/// coordinate is not finite or appears twice.
GridData with_sorted_axes(GridData grid);

/// The index of the variable in `names`; the first if it is empty. Throws InputError if there is none.
std::size_t find_variable(std::string_view variable, const std::vector<std::string>& names);
/// An index along `what` ("time") of `count` entries. Throws InputError if it is out of range.
std::size_t find_index(std::int64_t index, std::size_t count, std::string_view what);
/// The step of the request, of `count`. Throws InputError if there is none.
std::size_t find_time(const FieldRequest& request, std::size_t count);
/// (1 - weight) a + weight b, for two steps of one variable. Throws InputError if their points differ.
FieldData interpolated(FieldData a, const FieldData& b, double weight);

} // namespace GASPARD_API
