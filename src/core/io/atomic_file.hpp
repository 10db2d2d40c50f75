// Atomic writing: a file is written to a temporary name in the same folder and then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <string_view>
#include <vector>

namespace gaspard {

class TemporaryFile; // atomic_file.cpp

/// Calls `write` with a binary stream in the C locale. On any failure (an exception of `write`, a full disk,
/// a missing folder) the temporary file is removed and an existing file of that name remains unchanged.
/// Throws MachineError naming the file and the cause.
void write_atomically(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

/// The same in parts: the file appears when it is finished; until then, this has a temporary file in its
/// folder. What is not finished is removed. Throws MachineError as above.
class AtomicFile {
  public:
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    void write(std::string_view bytes);
    void finish();

  private:
    std::filesystem::path file_;
    std::unique_ptr<TemporaryFile> temporary_;
};

/// Whether this is the temporary file of a program that ended without completing it.
bool is_abandoned(const std::filesystem::path& file);
/// Removes those of a folder, as far as possible. What other programs are writing stays.
void remove_unfinished(const std::filesystem::path& folder);

/// Creates the folder and its parents if necessary. Throws MachineError naming the folder and the cause.
void make_folder(const std::filesystem::path& folder);
/// Creates the folder if necessary and checks that it is writable, so that this is known before solving.
/// Returns the folders that it created, innermost first. Throws InputError naming the folder and the cause
/// (MachineError for a full or failing disk).
std::vector<std::filesystem::path> check_writable(const std::filesystem::path& folder);
/// Removes those of these folders that are empty, in this order.
void remove_empty(const std::vector<std::filesystem::path>& folders);

} // namespace gaspard
