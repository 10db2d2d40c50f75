// The names in a folder, for a list to choose a file from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A folder whose content is wanted.
struct FolderWish {
    std::filesystem::path folder;
    std::vector<std::string_view> endings{}; ///< of the files, in any case; empty: all files
    bool files = true;                       ///< not only folders
    bool hidden = false;                     ///< also names that begin with a dot
    bool create = false;                     ///< make the folder first

    friend bool operator==(const FolderWish&, const FolderWish&) = default;
};

struct FolderListing {
    struct Entry {
        std::string name;
        bool folder = false;
        std::uintmax_t size = 0; ///< bytes; 0 for folders
        std::int64_t time = 0;   ///< of the last change, seconds since 1970; 0: not known
    };
    static constexpr std::size_t most = 2000; ///< entries; others are left out

    std::filesystem::path folder;
    std::vector<Entry> entries{}; ///< folders first, each in alphabetical order
    bool complete = true;         ///< there are no others
    std::string problem{};        ///< why there are none: "Permission denied"
};

/// Folders, and the files that are wanted. A folder that cannot be read has no entries, but a problem. Reads
/// the disk. Throws InputError if the folder is to be made and cannot be made.
FolderListing list_folder(const FolderWish& wish);

/// The folder that a typed path is in: "/a/b" and "/a/" are in "/a/"; a name alone in the working folder.
std::filesystem::path folder_of(const std::string& typed);

/// "512 B", "3.4 kB", "12 MB".
std::string size_text(std::uintmax_t bytes);
/// "2026-11-30 08:05", local time; empty if it is not known.
std::string time_text(std::int64_t time);

} // namespace gaspard
