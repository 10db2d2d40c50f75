#include "core/io/atomic_file.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <fcntl.h>
#include <locale>
#include <sstream>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace gaspard {

namespace fs = std::filesystem;

/// A file with a unique name, removed at the end unless it was moved to its destination. Member functions
/// return errno.
class TemporaryFile {
  public:
    TemporaryFile() = default;
    ~TemporaryFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (exists_) ::unlink(name_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int create_in(const fs::path& folder) {
        const std::string stem = ".gaspard-" + std::to_string(::getpid()) + "-";
        // O_EXCL makes the name unique: other threads and leftovers of a dead process take another number.
        for (int number = 0; descriptor_ < 0; ++number) {
            name_ = folder / (stem + std::to_string(number) + ".tmp");
            descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor_ < 0 && errno != EEXIST && errno != EINTR) return errno;
        }
        exists_ = true;
        return 0;
    }

    int write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR) return errno;
            if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
        }
        return 0;
    }

    int move_to(const fs::path& file) {
        // Without fsync, a crash soon after the rename may leave an empty file. EINVAL: not supported by the
        // file system.
        if (::fsync(descriptor_) != 0 && errno != EINVAL) return errno;
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0) return errno;
        if (::rename(name_.c_str(), file.c_str()) != 0) return errno;
        exists_ = false;
        return 0;
    }

  private:
    fs::path name_;
    int descriptor_ = -1;
    bool exists_ = false;
};

namespace {

std::string cause(int error) { return std::generic_category().message(error); }

void check_written(const fs::path& file, int error) {
    if (error != 0) throw MachineError("cannot write " + file.string() + ": " + cause(error));
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

int try_to_write(const fs::path& folder) {
    TemporaryFile trial;
    return trial.create_in(folder);
}

/// `folder` and its parents that do not exist, innermost first.
std::vector<fs::path> missing_folders(const fs::path& folder) {
    std::vector<fs::path> missing;
    std::error_code ignored; // a folder without access fails to be created below, with the cause
    for (fs::path p = folder; !p.empty() && !fs::exists(fs::symlink_status(p, ignored)); p = p.parent_path())
        missing.push_back(p);
    return missing;
}

} // namespace

AtomicFile::AtomicFile(fs::path file)
    : file_(std::move(file)), temporary_(std::make_unique<TemporaryFile>()) {
    check_written(file_, temporary_->create_in(folder_of(file_)));
}

AtomicFile::~AtomicFile() = default;

void AtomicFile::write(std::string_view bytes) { check_written(file_, temporary_->write(bytes)); }

void AtomicFile::finish() { check_written(file_, temporary_->move_to(file_)); }

void write_atomically(const fs::path& file, std::string_view bytes) {
    AtomicFile whole(file);
    whole.write(bytes);
    whole.finish();
}

void write_atomically(const fs::path& file, const std::function<void(std::ostream&)>& write) {
    // Write to memory first: if `write` throws, no file has been touched, and errno is known for file
    // errors.
    std::ostringstream stream(std::ios::binary);
    stream.imbue(std::locale::classic());
    stream.exceptions(std::ios::badbit | std::ios::failbit);
    write(stream);
    write_atomically(file, stream.view());
}

bool is_abandoned(const fs::path& file) {
    const std::string name = file.filename().string(), begin = ".gaspard-";
    if (!name.starts_with(begin) || !name.ends_with(".tmp")) return false;
    pid_t writer = 0;
    const char* const last = name.data() + name.size();
    const auto [end, code] = std::from_chars(name.data() + begin.size(), last, writer);
    return code == std::errc{} && end != last && *end == '-' && ::kill(writer, 0) != 0 && errno == ESRCH;
}

void remove_unfinished(const fs::path& folder) {
    std::error_code ignored;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (is_abandoned(entry.path())) files.push_back(entry.path());
    for (const fs::path& file : files) fs::remove(file, ignored);
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) throw MachineError("cannot make the folder " + folder.string() + ": " + error.message());
}

void remove_empty(const std::vector<fs::path>& folders) {
    std::error_code ignored; // of folders that are not empty, or were not created
    for (const fs::path& folder : folders) fs::remove(folder, ignored);
}

std::vector<fs::path> check_writable(const fs::path& folder) {
    std::vector<fs::path> made = missing_folders(folder);
    std::error_code error;
    fs::create_directories(folder, error);
    if (!error) error = std::error_code(try_to_write(folder), std::generic_category());
    if (!error) return made;
    remove_empty(made);
    const std::string sentence = "cannot write to the folder " + folder.string() + ": " + error.message();
    for (const int trouble : {ENOSPC, EDQUOT, EIO, EMFILE, ENFILE})
        if (error.value() == trouble) throw MachineError(sentence); // not specific to the folder
    throw InputError(sentence);
}

} // namespace gaspard
