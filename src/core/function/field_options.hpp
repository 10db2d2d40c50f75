// How a field of a file becomes a function on a domain (function/field_function.hpp).
#pragma once

#include "core/base/export.hpp"

namespace gaspard GASPARD_API {

enum class FieldTransform { none, absolute, logarithm, square };
enum class FieldPlacement {
    automatic, ///< by coordinates if the data cover at least half of the domain; else fitted
    coordinates,
    fit,
};
/// What stands where a value is missing or the domain has no data.
enum class MissingValues { nearest, lowest, error };

struct FieldOptions {
    FieldTransform transform = FieldTransform::none;
    FieldPlacement placement = FieldPlacement::automatic;
    MissingValues missing = MissingValues::nearest;
    double blur = 0; ///< sigma of the Gaussian blur, in cells of the uniform mesh
};

} // namespace GASPARD_API
