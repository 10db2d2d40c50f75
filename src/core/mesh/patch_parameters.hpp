// The parameters of points of a patch x = F(u, v), 0 <= u, v <= 1:
//
//   (u, v) = argmin |F(u, v) - x|
//
// This is the inverse of F for points of the patch, and for points beside it those of the nearest point.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

#include <array>

namespace gaspard GASPARD_API {

/// Whether two opposite edges of a patch are the same curve, as those of a full annulus are.
enum class PatchClosure {
    open,
    periodic, ///< F(0, v) = F(1, v) for all v
    flipped,  ///< F(0, v) = F(1, 1 - v), as on a Moebius strip
};

/// Immutable; may be called from several threads at once.
class PatchParameters {
  public:
    virtual ~PatchParameters() = default;
    /// u and v (the x and y of `uv`, with z = 0) of every point; resizes `uv`. Where F continues beyond the
    /// edges of the patch, u and v may leave [0, 1] by at most 0.1, except across edges that are one point or
    /// where the patch closes. On a seam, one of the two values is chosen; at an edge that is one point, any.
    virtual void find(const Points& x, Points& uv) const = 0;
    /// x = F(u, v); resizes `x`.
    virtual void points(const Points& uv, Points& x) const = 0;
    /// dF/du and dF/dv; resizes both.
    virtual void tangents(const Points& uv, Points& first, Points& second) const = 0;
    /// In the directions of u and of v.
    virtual std::array<PatchClosure, 2> closure() const = 0;
};

} // namespace GASPARD_API
