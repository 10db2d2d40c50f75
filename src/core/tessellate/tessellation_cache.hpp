// Tessellations of meshes, created by the first thread that needs them and shared: the solver's thread can
// prepare what the window's thread will show.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/solid_faces.hpp"
#include "core/tessellate/tessellation.hpp"

#include <memory>
#include <mutex>
#include <vector>

namespace gaspard {

class TessellationCache {
  public:
    /// The tessellation of the snapshot's mesh, fine enough for its node positions; created if necessary. The
    /// number of pieces of a mesh never decreases, to avoid flicker. Thread-safe.
    std::shared_ptr<const Tessellation> get(const Snapshot& snapshot);
    /// How the cells of the snapshot's mesh, which is of hexahedra, are joined. Thread-safe.
    std::shared_ptr<const SolidFaces> faces(const Snapshot& snapshot);

  private:
    struct Entry {
        std::weak_ptr<const Mesh> mesh;
        std::shared_ptr<const Tessellation> tessellation{};
        std::uint64_t version = 0; ///< last snapshot for which it was found fine enough
        std::shared_ptr<const SolidFaces> faces{};
    };
    Entry* find(const std::shared_ptr<const Mesh>& mesh);
    Entry& find_or_add(const std::shared_ptr<const Mesh>& mesh);

    std::mutex mutex_;
    std::vector<Entry> entries_; ///< of meshes that are still in use
};

} // namespace gaspard
