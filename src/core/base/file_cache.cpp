#include "core/base/file_cache.hpp"

#include <numeric>
#include <sys/stat.h>
#include <utility>

namespace gaspard {

namespace {

/// Changes whenever the file does; empty for what is no file.
std::string state_of(const std::string& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return {};
    std::string state;
    // ctim: the last change of its entry, which copying tools do not set back as they do that of its data.
    for (const auto number :
         {static_cast<long long>(status.st_dev), static_cast<long long>(status.st_ino),
          static_cast<long long>(status.st_size), static_cast<long long>(status.st_mtim.tv_sec),
          static_cast<long long>(status.st_mtim.tv_nsec), static_cast<long long>(status.st_ctim.tv_sec),
          static_cast<long long>(status.st_ctim.tv_nsec)})
        state += std::to_string(number) + ' ';
    return state;
}

} // namespace

std::shared_ptr<const void> FileCache::find(const std::string& file, std::string_view purpose,
                                            const std::function<Content()>& make) {
    std::string key = file + '\n' + std::string(purpose);
    std::string state = state_of(file);
    {
        const std::lock_guard lock(mutex_);
        for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
            if (entry->key != key) continue;
            if (entry->state != state) {
                entries_.erase(entry);
                break;
            }
            entries_.splice(entries_.begin(), entries_, entry);
            return entry->content.object;
        }
    }
    auto content = make();
    const std::lock_guard lock(mutex_);
    entries_.push_front({std::move(key), std::move(state), content});
    forget_oldest();
    return content.object;
}

void FileCache::forget_oldest() {
    std::size_t sum =
        std::accumulate(entries_.begin(), entries_.end(), std::size_t{0},
                        [](std::size_t bytes, const Entry& one) { return bytes + one.bytes(); });
    while (entries_.size() > 1 && (entries_.size() > most || sum > budget_)) {
        sum -= entries_.back().bytes();
        entries_.pop_back();
    }
}

} // namespace gaspard
