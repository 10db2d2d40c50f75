#include "gui/base/font_finder.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gaspard {

FontFinder::FontFinder(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this](std::stop_token stop) { work(stop); }) {}

void FontFinder::look_for(const std::vector<char32_t>& characters) {
    std::vector<char32_t> fresh;
    for (const char32_t c : characters)
        if (asked_.insert(c).second) fresh.push_back(c);
    if (fresh.empty()) return;
    {
        std::lock_guard lock(mutex_);
        wanted_.insert(wanted_.end(), fresh.begin(), fresh.end());
    }
    begin_.notify_one();
}

bool FontFinder::collect() {
    std::vector<SystemFont> found;
    {
        std::lock_guard lock(mutex_);
        found.swap(found_);
    }
    for (SystemFont& font : found) {
        const auto same = std::find_if(fonts_.begin(), fonts_.end(), [&](const SystemFont& one) {
            return one.number == font.number && one.bytes == font.bytes;
        });
        if (same == fonts_.end())
            fonts_.push_back(std::move(font));
        else
            same->characters.insert(same->characters.end(), font.characters.begin(), font.characters.end());
    }
    return !found.empty();
}

void FontFinder::work(std::stop_token stop) {
    while (true) {
        std::vector<char32_t> wanted;
        {
            std::unique_lock lock(mutex_);
            if (!begin_.wait(lock, stop, [this] { return !wanted_.empty(); }) || stop.stop_requested())
                return;
            wanted.swap(wanted_);
        }
        std::vector<SystemFont> found = system_fonts(std::move(wanted));
        if (found.empty()) continue;
        {
            std::lock_guard lock(mutex_);
            found_.insert(found_.end(), std::make_move_iterator(found.begin()),
                          std::make_move_iterator(found.end()));
        }
        wake_();
    }
}

} // namespace gaspard
