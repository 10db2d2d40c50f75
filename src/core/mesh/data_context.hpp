// What functions and monitors may use while they are made; the operators of the domain exist by then.
#pragma once

#include "core/base/export.hpp"
#include "core/base/file_cache.hpp"
#include "core/base/parameter.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/mesh/space.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>

namespace gaspard GASPARD_API {

/// Where the density of a convex domain is known.
struct DensityDomain {
    Points samples;                 ///< all over the domain, up to its boundary
    std::function<Vec3(Vec3)> into; ///< p itself, or, from outside, a point of the domain near the boundary
};

/// Those that read files or compute on the mesh report progress, and throw Interrupted if asked to stop.
struct DataContext {
    Space space{};                                  ///< the space of the domain
    const Discretisation* discretisation = nullptr; ///< null: made without a run
    std::shared_ptr<const DensityDomain> within{};  ///< null: the nodes of the mesh are in the domain
    const Values* pde = nullptr;                    ///< the section "pde" of the problem; null: it has none
    std::filesystem::path folder{};                 ///< base of relative paths; empty: the working directory
    std::shared_ptr<FileCache> files{};             ///< of the run; null: every file is read anew
    Progress progress{};
    std::stop_token stop{};
};

} // namespace GASPARD_API
