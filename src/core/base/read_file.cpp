#include "core/base/read_file.hpp"

#include "core/base/error.hpp"
#include "core/base/stopwatch.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <span>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace gaspard {

namespace {

std::string size_text(std::uintmax_t bytes) {
    return bytes >> 20 > 0 ? std::to_string(bytes >> 20) + " MiB" : std::to_string(bytes >> 10) + " KiB";
}

/// A file that is open for reading.
class Input {
  public:
    /// Without waiting for a named pipe to be opened for writing. To open a pipe again as /dev/stdin would
    /// wait for another writer.
    explicit Input(const std::filesystem::path& file)
        : descriptor_(file == "/dev/stdin" ? dup(STDIN_FILENO)
                                           : ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~Input() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;
    bool is_open() const { return descriptor_ >= 0; }

    /// Reads what there is, at least one byte except at the end; negative if it fails, with errno. Waits for
    /// data as long as something has the pipe open for writing. Throws Interrupted.
    ssize_t read(std::span<char> buffer, const std::stop_token& stop) {
        constexpr double patience = 10; // s, to wait for a writer of a pipe
        const Stopwatch watch;
        while (true) {
            const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
            if (count < 0 && errno == EINTR) continue;
            const bool later = count < 0 && errno == EAGAIN;
            if (count > 0 || (count < 0 && !later) || (count == 0 && !is_pipe())) return count;
            // Only poll() tells whether all writers have closed the pipe, or none has opened it yet.
            pollfd wait{descriptor_, POLLIN, 0};
            const bool event = ::poll(&wait, 1, 50) > 0;
            if (event && (wait.revents & POLLIN) == 0 && !later) return 0;
            if (stop.stop_requested()) throw Interrupted();
            if (event || later || watch.seconds() < patience) continue;
            errno = ETIMEDOUT;
            return -1;
        }
    }

  private:
    bool is_pipe() const {
        struct stat status {};
        return ::fstat(descriptor_, &status) == 0 && S_ISFIFO(status.st_mode);
    }

    int descriptor_;
};

} // namespace

std::string read_file(const std::filesystem::path& file, std::uintmax_t limit, const std::stop_token& stop) {
    const auto refuse = [&](const std::string& why) {
        throw InputError("cannot read " + file.string() + ": " + why);
    };
    const auto fail = [&](int error) {
        refuse(error == ETIMEDOUT ? "nothing writes to this pipe" : std::generic_category().message(error));
    };
    Input input(file);
    if (!input.is_open()) fail(errno);
    std::error_code none; // pipes and devices have no size
    const std::uintmax_t size = std::filesystem::file_size(file, none);
    const auto too_large = [&] { refuse("it is larger than " + size_text(limit)); };
    if (!none && size > limit) too_large();
    std::string bytes;
    if (!none) bytes.reserve(size);
    std::array<char, 1 << 16> buffer{};
    while (true) {
        const ssize_t count = input.read(buffer, stop);
        if (count < 0) fail(errno);
        if (count == 0) return bytes;
        if (bytes.size() + static_cast<std::size_t>(count) > limit) too_large();
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

} // namespace gaspard
