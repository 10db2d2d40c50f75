// Tessellations of meshes, made on whichever thread first asks and shared with all others: a solver's thread
// can make what a window's thread is to show.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/tessellation.hpp"

#include <memory>
#include <mutex>
#include <vector>

namespace gaspard {

class TessellationCache {
  public:
    /// Of the snapshot's mesh, cut finely enough for where its nodes stand. What is not there yet is made
    /// now; a mesh that has once needed finer pieces keeps them, lest they come and go. From any thread.
    std::shared_ptr<const Tessellation> get(const Snapshot& snapshot);

  private:
    struct Entry {
        std::weak_ptr<const Mesh> mesh;
        std::shared_ptr<const Tessellation> tessellation;
        std::uint64_t version = 0; ///< of the snapshot that it was last found fine enough for
    };
    Entry* find(const std::shared_ptr<const Mesh>& mesh);

    std::mutex mutex_;
    std::vector<Entry> entries_; ///< of meshes that somebody still has
};

} // namespace gaspard
