#include "core/tessellate/tessellation_cache.hpp"

#include <algorithm>

namespace gaspard {

std::shared_ptr<const Tessellation> TessellationCache::get(const std::shared_ptr<const Mesh>& mesh) {
    const auto find = [&]() -> std::shared_ptr<const Tessellation> {
        std::erase_if(entries_, [](const Entry& entry) { return entry.first.expired(); });
        const auto found = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& entry) { return entry.first.lock() == mesh; });
        return found == entries_.end() ? nullptr : found->second;
    };
    {
        std::lock_guard lock(mutex_);
        if (auto known = find()) return known;
    }
    auto made = std::make_shared<const Tessellation>(tessellate(*mesh)); // others need not wait for this
    std::lock_guard lock(mutex_);
    if (auto known = find()) return known; // another thread was quicker: all share one
    entries_.emplace_back(mesh, made);
    return made;
}

} // namespace gaspard
