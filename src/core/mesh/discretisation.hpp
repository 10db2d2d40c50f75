// The immutable operators of one domain at one resolution: spaces, quadrature, factorisations. Made once by
// `prepare` and shared by all runs that use them. Methods use the derived class, which the capability table
// determines.
#pragma once

#include "core/base/export.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/patch_list.hpp"
#include "core/mesh/patch_parameters.hpp"
#include "core/mesh/solid_shape.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

template <std::size_t D>
class TensorMap;      // core/spline/patch_map.hpp
struct DensityDomain; // core/mesh/data_context.hpp

/// Reports the progress of long work: the fraction done, from 0 to 1, and a description of the current step.
/// Called on the thread that does the work.
using Progress = std::function<void(double, std::string_view)>;

class Discretisation {
  public:
    virtual ~Discretisation() = default;
    /// The computational mesh.
    virtual std::shared_ptr<const Mesh> mesh() const = 0;
    /// The control points of a planar patch if the user may move them; otherwise null.
    virtual std::shared_ptr<const Points> control_points() const { return nullptr; }
    /// How many of these follow each other in the first direction; 0 where they are no net.
    virtual std::size_t control_columns() const { return 0; }
    /// Of transport to another domain: points of its boundary, in their order; null: the mesh stays in its
    /// own.
    virtual std::shared_ptr<const Points> target_outline() const { return nullptr; }
    /// Where the monitor and the density of the source are known; null: at the nodes of the mesh, wherever
    /// they go.
    virtual std::shared_ptr<const DensityDomain> target_region() const { return nullptr; }
    virtual std::shared_ptr<const DensityDomain> source_region() const { return nullptr; }
    /// What is to be said of the domain, in sentences without a full stop.
    virtual std::vector<std::string> notes() const { return {}; }
    /// The patches of the domain's file if it has several; otherwise null.
    virtual std::shared_ptr<const PatchList> patches() const { return nullptr; }
    /// The parameters of points of a patch; null on other domains.
    virtual std::shared_ptr<const PatchParameters> parameters() const { return nullptr; }
    /// The map of the parameter square to a spline patch; null on other domains.
    virtual std::shared_ptr<const TensorMap<2>> patch_map() const { return nullptr; }
    /// The map of the parameter cube to a spline solid; null on other domains.
    virtual std::shared_ptr<const TensorMap<3>> solid_map() const { return nullptr; }
    /// Where a spline solid lies; null on other domains.
    virtual std::shared_ptr<const SolidShape> solid_shape() const { return nullptr; }
    /// Number of unknowns.
    virtual std::size_t unknowns() const = 0;
};

} // namespace GASPARD_API
