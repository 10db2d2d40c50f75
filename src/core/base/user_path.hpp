// Paths as users write them.
#pragma once

#include <filesystem>
#include <string_view>

namespace gaspard {

/// The path of a text; a leading `~` or `~/` is the user's home folder ($HOME). Throws InputError if it is
/// needed and not known.
std::filesystem::path user_path(std::string_view text);
/// The same, relative to a folder; an empty folder is the working directory.
std::filesystem::path user_path(std::string_view text, const std::filesystem::path& folder);
/// Whether a value of a row with the role `file` is a path: not empty, and not the content itself ("{ ...",
/// "data:...").
bool is_path(std::string_view text);
/// Whether a name ends in an extension such as ".toml", in any case.
bool has_extension(const std::filesystem::path& file, std::string_view extension);

} // namespace gaspard
