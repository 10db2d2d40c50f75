// A PDE that is solved on the mesh, as the user sees it: a name and rows for its coefficients.
#pragma once

#include "core/base/parameter.hpp"

namespace gaspard {

/// Methods get the values of the rows in ProblemData::pde.
struct PdeType {
    std::string name;
    std::string label;
    std::string help;
    std::string equation; ///< with the rows' symbols
    std::vector<ParameterRow> rows;
};

} // namespace gaspard
