// A kind of domain as the user sees it: a name, its parameter rows, and what its points know of distance.
#pragma once

#include "core/base/parameter.hpp"
#include "core/mesh/space.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gaspard {

struct DomainType {
    std::string name;
    std::string label;
    std::string help;
    std::vector<ParameterRow> rows;
    std::function<Space(const Values&)> space;
};

/// The unit square: doubly periodic, or with walls along which nodes slide.
DomainType plane_domain();

} // namespace gaspard
