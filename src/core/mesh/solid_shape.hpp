// Where a solid x = F(xi), 0 <= xi <= 1, lies in space:
//
//   nearest(x) = F(argmin |F(xi) - x|)
//
// which is x itself inside of it.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

namespace gaspard GASPARD_API {

/// Immutable; may be called from several threads at once.
class SolidShape {
  public:
    virtual ~SolidShape() = default;
    /// The nearest point of the solid of every point; resizes `nearest`. Beside a solid that is not convex it
    /// may be another point of the boundary that is nearly as near.
    virtual void nearest(const Points& x, Points& nearest) const = 0;
    virtual double volume() const = 0;
    /// The solid is its bounding box.
    virtual bool is_box() const = 0;
};

} // namespace GASPARD_API
