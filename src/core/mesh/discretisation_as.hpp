// The class of a discretisation is determined by the capability table: its rows and the methods they list
// know it.
#pragma once

#include "core/base/check.hpp"
#include "core/mesh/discretisation.hpp"

#include <memory>
#include <utility>

namespace gaspard {

/// The discretisation must be of class Discretised (GASPARD_CHECK).
template <class Discretised>
std::shared_ptr<const Discretised> discretisation_as(std::shared_ptr<const Discretisation> discretisation) {
    auto own = std::dynamic_pointer_cast<const Discretised>(std::move(discretisation));
    GASPARD_CHECK(own != nullptr);
    return own;
}

} // namespace gaspard
