#include "core/base/data_uri.hpp"

#include "core/base/user_path.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace gaspard {

namespace {

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t at) {
            return at < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[at])) : 0U;
        };
        const unsigned group = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
        const std::size_t present = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= present ? digits[group >> (18U - 6U * static_cast<unsigned>(k)) & 63U] : '=';
    }
    return text;
}

} // namespace

std::string data_uri(std::string_view bytes, std::string_view media_type) {
    return "data:" + std::string(media_type) + ";base64," + base64(bytes);
}

std::string_view media_type_of(const std::filesystem::path& file) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 8> known = {{
        {".png", "image/png"},
        {".jpg", "image/jpeg"},
        {".jpeg", "image/jpeg"},
        {".csv", "text/csv"},
        {".json", "application/json"},
        {".xml", "application/xml"},
        {".vtu", "application/xml"},
        {".nc", "application/x-netcdf"},
    }};
    for (const auto& [ending, type] : known)
        if (has_extension(file, ending)) return type;
    return "application/octet-stream";
}

} // namespace gaspard
