// The immutable operators of one domain at one resolution: spaces, quadrature, factorisations.
// Made once by `prepare`, shared by all runs that use it. What a method needs beyond this, it asks of the
// derived class that the capability table promises.
#pragma once

#include "core/mesh/mesh.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

namespace gaspard {

/// Called during long work, on the thread that works: a fraction from 0 to 1 and what is being done.
using Progress = std::function<void(double, std::string_view)>;

class Discretisation {
  public:
    virtual ~Discretisation() = default;
    /// The computational mesh, whose nodes a method moves.
    virtual std::shared_ptr<const Mesh> mesh() const = 0;
    /// Of a patch in the plane whose control points a user may move; null for others.
    virtual std::shared_ptr<const Points> control_points() const { return nullptr; }
    /// How many numbers an iteration determines.
    virtual std::size_t unknowns() const = 0;
};

} // namespace gaspard
