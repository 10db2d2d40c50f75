// The names in a folder, for a list to choose a file from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct FolderListing {
    struct Entry {
        std::string name;
        bool folder = false;
    };
    static constexpr std::size_t most = 2000; ///< entries; others are left out

    std::filesystem::path folder;
    std::vector<Entry> entries; ///< folders first, each in alphabetical order; hidden ones are left out
    bool complete = true;       ///< there are no others
};

/// Folders, and files whose names have one of these endings in any case. A folder that cannot be read has no
/// entries. Reads the disk.
FolderListing list_folder(const std::filesystem::path& folder, const std::vector<std::string_view>& endings);

/// The folder that a typed path is in: "/a/b" and "/a/" are in "/a/"; a name alone in the working folder.
std::filesystem::path folder_of(const std::string& typed);

} // namespace gaspard
