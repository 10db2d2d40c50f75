// The patches of a file that has several, for the user to choose from.
#pragma once

#include "core/base/export.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

struct PatchList {
    std::vector<std::string> labels; ///< of patch 1, 2, ...: "1: TensorNurbs2, id 100"
    std::size_t chosen = 0;          ///< index of the one in use
    std::string note;                ///< "patch 1 of 312 (TensorNurbs2, id 100)"
};

} // namespace GASPARD_API
