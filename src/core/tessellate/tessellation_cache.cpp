#include "core/tessellate/tessellation_cache.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

TessellationCache::Entry* TessellationCache::find(const std::shared_ptr<const Mesh>& mesh) {
    std::erase_if(entries_, [](const Entry& entry) { return entry.mesh.expired(); });
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& entry) { return entry.mesh.lock() == mesh; });
    return found == entries_.end() ? nullptr : &*found;
}

TessellationCache::Entry& TessellationCache::find_or_add(const std::shared_ptr<const Mesh>& mesh) {
    Entry* known = find(mesh);
    return known != nullptr ? *known : entries_.emplace_back(Entry{.mesh = mesh});
}

std::shared_ptr<const SolidFaces> TessellationCache::faces(const Snapshot& snapshot) {
    {
        const std::lock_guard lock(mutex_);
        if (const Entry* known = find(snapshot.mesh); known != nullptr && known->faces) return known->faces;
    }
    auto made = std::make_shared<const SolidFaces>(solid_faces(*snapshot.mesh)); // not under the lock
    const std::lock_guard lock(mutex_);
    auto& faces = find_or_add(snapshot.mesh).faces;
    if (!faces) faces = std::move(made);
    return faces;
}

std::shared_ptr<const Tessellation> TessellationCache::get(const Snapshot& snapshot) {
    const Mesh& mesh = *snapshot.mesh;
    int cuts = 0; // of the cached tessellation
    {
        const std::lock_guard lock(mutex_);
        if (const Entry* known = find(snapshot.mesh); known != nullptr && known->tessellation) {
            if (known->version == snapshot.version || mesh.kind.order == 1) return known->tessellation;
            cuts = known->tessellation->cuts;
        }
    }
    // Not under the lock, so that other threads do not wait.
    int needed = std::max(cuts, cuts_for(mesh, snapshot.x));
    if (cuts == 0) needed = std::max(needed, cuts_for(mesh, mesh.nodes));
    std::shared_ptr<const Tessellation> made;
    if (needed > cuts) made = std::make_shared<const Tessellation>(tessellate(mesh, needed));
    const std::lock_guard lock(mutex_);
    Entry& known = find_or_add(snapshot.mesh);
    // If another thread was faster, use its result.
    if (made && (!known.tessellation || known.tessellation->cuts < made->cuts)) known.tessellation = made;
    known.version = snapshot.version;
    return known.tessellation;
}

} // namespace gaspard
