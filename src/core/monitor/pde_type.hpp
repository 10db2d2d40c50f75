// A type of PDE solved on the mesh, as the user sees it: its name and the rows of its coefficients.
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"

namespace gaspard GASPARD_API {

/// Methods read the values of the rows from ProblemData::pde.
struct PdeType {
    std::string name;
    std::string label;
    std::string help;
    std::string equation; ///< with the symbols of the rows
    std::vector<ParameterRow> rows;
};

} // namespace GASPARD_API
