#include "core/base/user_path.hpp"

#include "core/base/error.hpp"
#include "core/base/letters.hpp"
#include "core/base/read_data_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace gaspard {

std::filesystem::path user_path(std::string_view text) {
    if (text != "~" && !text.starts_with("~/")) return text;
    const char* home = std::getenv("HOME");
    if (home == nullptr || *home == '\0')
        throw InputError("cannot expand '" + std::string(text) + "': HOME is not set");
    text.remove_prefix(std::min<std::size_t>(2, text.size()));
    return std::filesystem::path(home) / text;
}

std::filesystem::path user_path(std::string_view text, const std::filesystem::path& folder) {
    const std::filesystem::path path = user_path(text);
    return path.is_relative() && !folder.empty() ? folder / path : path;
}

bool is_path(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] != '{' && !is_data_uri(text) &&
           !is_shipped_data(text);
}

bool has_extension(const std::filesystem::path& file, std::string_view extension) {
    return same_word(file.extension().string(), extension);
}

} // namespace gaspard
