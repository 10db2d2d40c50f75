#include "core/base/read_data_file.hpp"

#include "core/base/error.hpp"
#include "core/base/letters.hpp"
#include "core/base/number_text.hpp"
#include "core/base/user_path.hpp"
#include "core_assets.hpp"

#include <cstddef>
#include <utility>

namespace gaspard {

namespace {

constexpr std::string_view scheme = "data:", shipped = "gaspard:", surrounding_blanks = " \t\r\n";

std::string_view without_blanks(std::string_view text) {
    const auto begin = text.find_first_not_of(surrounding_blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(surrounding_blanks) + 1 - begin);
}

int hexadecimal(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char small = lower_case(c);
    return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

/// Text with percent escapes such as %20.
std::string decode_escapes(std::string_view text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            bytes += text[i];
            continue;
        }
        const int high = i + 2 < text.size() ? hexadecimal(text[i + 1]) : -1;
        const int low = i + 2 < text.size() ? hexadecimal(text[i + 2]) : -1;
        if (high < 0 || low < 0)
            throw InputError("the data: URI has a '%' without two hexadecimal digits after it");
        bytes += static_cast<char>(16 * high + low);
        i += 2;
    }
    return bytes;
}

std::string decode_uri(std::string_view text, std::uintmax_t limit) {
    text = without_blanks(text).substr(scheme.size());
    const auto comma = text.find(',');
    if (comma == std::string_view::npos)
        throw InputError("the data: URI has no comma; it must be data:<type>;base64,<data>");
    const std::string_view type = without_blanks(text.substr(0, comma)), data = text.substr(comma + 1);
    const auto semicolon = type.rfind(';');
    const bool base64 = semicolon != std::string_view::npos &&
                        same_word(without_blanks(type.substr(semicolon + 1)), "base64");
    if ((base64 ? data.size() / 4 * 3 : data.size() / 3) > limit)
        throw InputError("the data: URI has more than " + std::to_string(limit >> 10) + " KiB");
    if (!base64) return decode_escapes(data);
    auto bytes = decode_base64(data);
    if (!bytes) throw InputError("the data: URI is not valid base64");
    return std::move(*bytes);
}

std::string shipped_data(std::string_view text) {
    const std::string name(without_blanks(text).substr(shipped.size()));
    for (const auto& file : core_assets::files())
        if (file.path == "assets/pictures/" + name || file.path == "assets/fields/" + name ||
            file.path == "assets/meshes/" + name)
            return std::string(file.bytes);
    throw InputError("the program has no file " + std::string(without_blanks(text)));
}

} // namespace

bool is_data_uri(std::string_view text) {
    return same_word(without_blanks(text).substr(0, scheme.size()), scheme);
}

bool is_shipped_data(std::string_view text) { return without_blanks(text).starts_with(shipped); }

std::string data_file_name(std::string_view text, const std::filesystem::path& folder) {
    if (is_shipped_data(text)) return std::string(without_blanks(text));
    return is_data_uri(text) ? "the packed data" : user_path(text, folder).string();
}

std::string read_data_file(std::string_view text, const std::filesystem::path& folder, std::uintmax_t limit) {
    if (is_shipped_data(text)) return shipped_data(text);
    return is_data_uri(text) ? decode_uri(text, limit) : read_file(user_path(text, folder), limit);
}

} // namespace gaspard
