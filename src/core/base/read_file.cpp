#include "core/base/read_file.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <unistd.h>

namespace gaspard {

namespace {

std::string size_text(std::uintmax_t bytes) {
    return bytes >> 20 > 0 ? std::to_string(bytes >> 20) + " MiB" : std::to_string(bytes >> 10) + " KiB";
}

/// To open a named pipe again as /dev/stdin would wait for another writer.
std::FILE* open(const std::filesystem::path& file) {
    if (file != "/dev/stdin") return std::fopen(file.c_str(), "rb");
    const int input = dup(STDIN_FILENO);
    return input < 0 ? nullptr : fdopen(input, "rb");
}

} // namespace

std::string read_file(const std::filesystem::path& file, std::uintmax_t limit) {
    const auto refuse = [&](const std::string& why) {
        throw InputError("cannot read " + file.string() + ": " + why);
    };
    const auto fail = [&](int error) { refuse(std::generic_category().message(error)); };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(open(file), &std::fclose);
    if (!stream) fail(errno);
    std::error_code none; // pipes and devices have no size
    const std::uintmax_t size = std::filesystem::file_size(file, none);
    const auto too_large = [&] { refuse("it is larger than " + size_text(limit)); };
    if (!none && size > limit) too_large();
    std::string bytes;
    if (!none) bytes.reserve(size);
    char buffer[1 << 16];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stream.get())) {
        if (bytes.size() + count > limit) too_large();
        bytes.append(buffer, count);
    }
    if (std::ferror(stream.get())) fail(errno);
    return bytes;
}

} // namespace gaspard
