#include "gui/base/folder_listing.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <system_error>
#include <tuple>

namespace gaspard {

namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool ends_in_one(const std::filesystem::path& file, const std::vector<std::string_view>& endings) {
    return std::any_of(endings.begin(), endings.end(),
                       [&](std::string_view ending) { return has_extension(file, ending); });
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw InputError("cannot make the folder " + folder.string() + ": " + failed.message());
}

FolderListing::Entry entry_of(const std::filesystem::directory_entry& found, bool inside) {
    std::error_code unknown;
    FolderListing::Entry entry{.name = found.path().filename().string(), .folder = inside};
    if (!inside) {
        const auto size = found.file_size(unknown);
        if (!unknown) entry.size = size;
    }
    const auto time = found.last_write_time(unknown);
    if (!unknown)
        entry.time = std::chrono::duration_cast<std::chrono::seconds>(
                         std::chrono::file_clock::to_sys(time).time_since_epoch())
                         .count();
    return entry;
}

} // namespace

FolderListing list_folder(const FolderWish& wish) {
    if (wish.create) make_folder(wish.folder);
    FolderListing listing{.folder = wish.folder};
    std::error_code failed;
    std::filesystem::directory_iterator at(wish.folder, failed);
    if (failed) listing.problem = failed.message();
    for (; !failed && at != std::filesystem::directory_iterator(); at.increment(failed)) {
        std::error_code unknown;
        const bool inside = at->is_directory(unknown);
        if (!wish.hidden && at->path().filename().string().starts_with(".")) continue;
        const bool fits = wish.files && (wish.endings.empty() || ends_in_one(at->path(), wish.endings));
        if (!inside && !fits) continue;
        listing.complete = listing.entries.size() < FolderListing::most;
        if (!listing.complete) break;
        listing.entries.push_back(entry_of(*at, inside));
    }
    std::sort(listing.entries.begin(), listing.entries.end(), [](const auto& a, const auto& b) {
        return std::tuple(!a.folder, lower(a.name), a.name) < std::tuple(!b.folder, lower(b.name), b.name);
    });
    return listing;
}

std::filesystem::path folder_of(const std::string& typed) {
    std::filesystem::path path = typed;
    try {
        path = user_path(typed);
    } catch (const InputError&) { // no home folder, as opening will say
    }
    const auto parent = path.parent_path();
    return std::filesystem::absolute(parent.empty() ? "." : parent).lexically_normal();
}

std::string size_text(std::uintmax_t bytes) {
    if (bytes < 1000) return std::to_string(bytes) + " B";
    auto size = static_cast<double>(bytes) / 1000;
    std::size_t unit = 0;
    constexpr std::array<const char*, 4> units = {"kB", "MB", "GB", "TB"};
    for (; size >= 999.5 && unit + 1 < units.size(); ++unit) size /= 1000;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), size < 9.95 ? "%.1f %s" : "%.0f %s", size, units[unit]);
    return text.data();
}

std::string time_text(std::int64_t time) {
    if (time == 0) return {};
    const std::time_t seconds = time;
    std::tm parts{};
    std::array<char, 32> text{};
    if (localtime_r(&seconds, &parts) == nullptr) return {};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts);
    return text.data();
}

} // namespace gaspard
