// Words and numbers of text files, line by line, whatever the locale is.
#pragma once

#include "core/base/error.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

namespace gaspard {

/// The next word of `rest`, which keeps what follows it; empty at the end.
inline std::string_view next_word(std::string_view& rest) {
    constexpr std::string_view blank = " \t\r\n\f\v";
    const auto begin = std::min(rest.find_first_not_of(blank), rest.size());
    const auto end = std::min(rest.find_first_of(blank, begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

/// Throws InputError if the word is anything but one number in range.
template <class Number>
Number number_in(std::string_view word) {
    Number value{};
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
        throw InputError(word.empty() ? std::string("a number is missing")
                                      : "'" + std::string(word.substr(0, 40)) + "' is not a number");
    if (error == std::errc::result_out_of_range)
        throw InputError("'" + std::string(word.substr(0, 40)) + "' is out of range");
    return value;
}

/// Lines without their ends (LF or CR LF) and without comments.
class Lines {
  public:
    Lines(std::string_view text, char comment) : rest_(text), comment_(comment) {}

    /// Goes to the next line that has a word; false at the end.
    bool next() {
        while (!rest_.empty()) {
            const auto end = std::min(rest_.find('\n'), rest_.size());
            line_ = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++number_;
            if (comment_ != 0) line_ = line_.substr(0, line_.find(comment_));
            std::string_view copy = line_;
            if (!next_word(copy).empty()) return true;
        }
        return false;
    }
    std::string_view line() const { return line_; }

    /// Calls `parse`, and adds the line's number to the text of an InputError.
    template <class Parse>
    void at_line(const Parse& parse) const {
        try {
            parse();
        } catch (const InputError& error) {
            throw InputError("line " + std::to_string(number_) + ": " + error.what());
        }
    }

  private:
    std::string_view rest_, line_;
    char comment_;
    std::size_t number_ = 0;
};

} // namespace gaspard
