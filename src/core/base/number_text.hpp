// Numbers in text files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A decimal number, with a sign or without, or a quotient of two ("1/2"), whatever the locale; nullopt if
/// the word is anything else, or the number is not finite. Numbers too small for a double are 0.
std::optional<double> parse_number(std::string_view word);

/// The numbers between blanks and line ends. Throws InputError that names `what` and the first word that is
/// not a number.
std::vector<double> parse_numbers(std::string_view text, const std::string& what);

/// The bytes of base64 text (RFC 4648), blanks and line ends ignored; nullopt if it is not base64.
std::optional<std::string> decode_base64(std::string_view text);

/// The numbers that base64 text encodes, in little-endian order. `type`: "float32", "float64", "int16",
/// "uint16", ... to 64. Throws InputError that names `what`.
std::vector<double> decode_numbers(std::string_view base64, std::string_view type, const std::string& what);

} // namespace gaspard
