// What the readers of legacy and XML files of VTK share: a file as its geometry and the names of its arrays,
// of which one is read.
#pragma once

#include "core/data/field_data.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// Numbers as VTK names them in both kinds of file ("float", "Float32"), in any case.
struct VtkType {
    bool real = false, is_signed = true;
    std::size_t bytes = 0;
};
/// nullopt if the type is unknown, or has no fixed size in files ("bit", "string").
std::optional<VtkType> vtk_type(std::string_view name);
/// The numbers in `bytes`, as many as there are whole ones.
std::vector<double> vtk_numbers(std::string_view bytes, const VtkType& type, bool big_endian);

/// A number in ASCII; "nan", "inf" and what is too large for a double are not finite: missing values.
std::optional<double> vtk_number(std::string_view word);

struct VtkArray {
    std::string name;
    bool of_cells = false;
    std::size_t components = 1;
    std::function<std::vector<double>()>
        read; ///< all components of all points or cells; called while the file is open
};

/// Cells as lists of points: cell c has the points connectivity[offsets[c]] to connectivity[offsets[c + 1] -
/// 1].
struct VtkCells {
    std::vector<std::size_t> offsets, connectivity;
};

struct VtkFile {
    /// Axes of a rectilinear grid; without it, points.
    std::optional<std::array<std::vector<double>, 3>> axes{};
    std::vector<double> points{};           ///< x, y, z of each
    std::array<std::size_t, 3> structure{}; ///< points along each direction of a structured grid, else 0
    std::function<VtkCells()> cells{};      ///< of an unstructured grid
    std::vector<VtkArray> arrays{};
};

/// Reads the requested array: points or centres of cells with values, as a grid if they are one. The length
/// of vectors is their value. Of a grid with three directions a plane is read, with the index `request.level`
/// along z, unless the request has three.
FieldData vtk_field(const VtkFile& file, const FieldRequest& request);

/// Of a grid; its coordinates are made before its values are read.
inline constexpr std::size_t longest_axis = std::size_t{1} << 20;

/// a * b * c. Throws InputError with `what` if there are more than largest_field.
std::size_t checked_product(std::size_t a, std::size_t b, std::size_t c, std::string_view what);

} // namespace gaspard
