// Preparing the values of a field before they are interpolated: the transform, and values that are missing.
#pragma once

#include "core/data/field_data.hpp"
#include "core/function/field_function.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace gaspard {

/// Transforms the values, and replaces or removes those that are missing. Appends notes. Throws InputError if
/// values are missing and must not be.
void prepare_values(GridData& grid, const FieldOptions& options, std::vector<std::string>& notes);
void prepare_values(ScatteredData& data, const FieldOptions& options, std::vector<std::string>& notes);
/// Throws the InputError of values that are missing and must not be. `where`: of which part of the field,
/// such as in_step(); empty: of all.
[[noreturn]] void refuse_missing(std::size_t missing, std::size_t all, const std::string& where = {});

} // namespace gaspard
