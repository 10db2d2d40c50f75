#include "core/base/file_cache.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

namespace gaspard {

namespace {

/// Changes whenever the file does; empty for what is no file.
std::string state_of(const std::string& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (error) return {};
    const auto time = std::filesystem::last_write_time(file, error);
    if (error) return {};
    return std::to_string(size) + " " + std::to_string(time.time_since_epoch().count());
}

} // namespace

std::shared_ptr<const void> FileCache::find(const std::string& file, std::string_view purpose,
                                            const std::function<std::shared_ptr<const void>()>& make) {
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
            return entry->content;
        }
    }
    auto content = make();
    const std::lock_guard lock(mutex_);
    entries_.push_front({std::move(key), std::move(state), content});
    if (entries_.size() > most) entries_.pop_back();
    return content;
}

} // namespace gaspard
