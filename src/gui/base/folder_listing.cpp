#include "gui/base/folder_listing.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"

#include <algorithm>
#include <cctype>
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

} // namespace

FolderListing list_folder(const std::filesystem::path& folder, const std::vector<std::string_view>& endings) {
    FolderListing listing{.folder = folder, .entries = {}};
    std::error_code failed;
    std::filesystem::directory_iterator at(folder, failed);
    for (; !failed && at != std::filesystem::directory_iterator(); at.increment(failed)) {
        const std::string name = at->path().filename().string();
        std::error_code unknown;
        const bool inside = at->is_directory(unknown);
        if (name.starts_with(".") || (!inside && !ends_in_one(at->path(), endings))) continue;
        listing.complete = listing.entries.size() < FolderListing::most;
        if (!listing.complete) break;
        listing.entries.push_back({name, inside});
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

} // namespace gaspard
