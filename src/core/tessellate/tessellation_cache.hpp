// Tessellations of meshes, made on whichever thread first asks and shared with all others: a solver's thread
// can make what a window's thread is to show.
#pragma once

#include "core/tessellate/tessellation.hpp"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gaspard {

class TessellationCache {
  public:
    /// Of a mesh that is not there yet it is made now. From any thread.
    std::shared_ptr<const Tessellation> get(const std::shared_ptr<const Mesh>& mesh);

  private:
    using Entry = std::pair<std::weak_ptr<const Mesh>, std::shared_ptr<const Tessellation>>;

    std::mutex mutex_;
    std::vector<Entry> entries_; ///< of meshes that somebody still has
};

} // namespace gaspard
