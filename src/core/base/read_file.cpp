#include "core/base/read_file.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace gaspard {

std::string read_file(const std::filesystem::path& file) {
    const auto fail = [&](int error) {
        throw InputError("cannot read " + file.string() + ": " + std::generic_category().message(error));
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"),
                                                                 &std::fclose);
    if (!stream) fail(errno);
    std::string bytes;
    char buffer[1 << 16];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stream.get()))
        bytes.append(buffer, count);
    if (std::ferror(stream.get())) fail(errno);
    return bytes;
}

} // namespace gaspard
