// Where the window writes files: below its output folder, or elsewhere if that cannot be written.
#pragma once

#include <filesystem>
#include <string>

namespace gaspard {

struct OutputFolders {
    std::filesystem::path preferred;
    std::filesystem::path fallback{}; ///< where nothing can be written below the first; empty: nowhere else
};

struct WritableFolder {
    std::filesystem::path folder;
    std::string remark; ///< why it is not the preferred one, to be added to a sentence; else empty
};

/// A folder with this name, created if necessary and writable. Throws InputError if neither of the two can be
/// written, MachineError if the disk is full or fails.
WritableFolder writable_folder(const OutputFolders& folders, const std::string& name);

/// "gaspard-out" in the user's home folder; empty if there is none.
std::filesystem::path home_output();

} // namespace gaspard
