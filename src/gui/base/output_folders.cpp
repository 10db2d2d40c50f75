#include "gui/base/output_folders.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"

#include <cstdlib>

namespace gaspard {

WritableFolder writable_folder(const OutputFolders& folders, const std::string& name) {
    try {
        check_writable(folders.preferred / name);
        return {folders.preferred / name, {}};
    } catch (const InputError& error) {
        if (folders.fallback.empty()) throw;
        try {
            check_writable(folders.fallback / name);
        } catch (const InputError& second) {
            throw InputError(std::string(error.what()) + "; " + second.what());
        }
        return {folders.fallback / name, ", because " + folders.preferred.string() + " cannot be written"};
    }
}

std::filesystem::path home_output() {
    const char* home = std::getenv("HOME");
    const std::filesystem::path folder(home ? home : "");
    return folder.is_absolute() ? folder / "gaspard-out" : std::filesystem::path();
}

} // namespace gaspard
