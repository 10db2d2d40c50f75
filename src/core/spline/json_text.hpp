// JSON from files of users.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace gaspard {

/// Parses JSON. Throws InputError, without a file's name, for a syntax error, a number that is too large for
/// a double, a key that occurs twice in an object, and more than 100 levels.
nlohmann::json parse_json(std::string_view text);

} // namespace gaspard
