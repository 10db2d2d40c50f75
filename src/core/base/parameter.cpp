#include "core/base/parameter.hpp"

#include "core/base/check.hpp"
#include "core/base/join.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <set>

namespace gaspard {

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
        }
    }
    return row[b.size()];
}

std::string kind_name(ParameterKind kind) {
    switch (kind) {
    case ParameterKind::real:
        return "a number";
    case ParameterKind::real_or_auto:
        return "a number or \"auto\"";
    case ParameterKind::integer:
        return "an integer";
    case ParameterKind::boolean:
        return "true or false";
    case ParameterKind::choice:
        return "one of the listed names";
    case ParameterKind::text:
        return "a string";
    }
    return {};
}

enum class Reading { number, too_large, none };

/// Whether a text that from_chars finds out of range is too small, as 1e-400 is.
bool is_tiny(std::string_view text) {
    const auto power = text.find_first_of("eE");
    if (power != std::string_view::npos) return text.substr(power + 1).starts_with('-');
    return text.find_first_not_of("-+0") == text.find('.');
}

template <class Number>
Reading read_all(std::string_view text, Number& number) {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (end != text.data() + text.size()) return Reading::none;
    if (code == std::errc{}) return Reading::number;
    if (code != std::errc::result_out_of_range) return Reading::none;
    if (std::is_integral_v<Number> || !is_tiny(text)) return Reading::too_large;
    number = 0;
    return Reading::number;
}

// A real number keeps its decimal point, so that 60.0 is not printed as the integer 60.
std::string written_value(const Value& value) {
    const double* real = std::get_if<double>(&value);
    if (real == nullptr) return format_value(value);
    const bool whole = std::abs(*real) < 1e5 && *real == std::floor(*real);
    return exact_number(*real) + (whole ? ".0" : "");
}

void check_range(const std::string& name, const ParameterRow& row, double value) {
    if (!std::isfinite(value))
        throw InputError(name + " must be a finite number, not " + exact_number(value));
    if (value < row.minimum || value > row.maximum)
        throw InputError(name + " = " + exact_number(value) + " is out of range: " + describe_range(row) +
                         (row.help.empty() ? "" : " (" + row.help + ")"));
}

const std::string& present_choice(const ParameterRow& row, const std::string& word) {
    for (const auto& [former, present] : row.former_choices)
        if (former == word) return present;
    return word;
}

} // namespace

std::string format_number(double value) {
    if (std::isnan(value)) return "nan"; // whatever its sign
    char buffer[32];
    const auto [end, code] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return code == std::errc{} ? std::string(buffer, end) : std::string("nan");
}

std::string format_number(const std::optional<double>& value) { return value ? format_number(*value) : ""; }

std::string format_value(const Value& value) {
    if (const auto* real = std::get_if<double>(&value)) return format_number(*real);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
    if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
    return std::get<std::string>(value);
}

std::string describe_range(const ParameterRow& row) {
    if (row.kind == ParameterKind::choice) return join(row.choices, ", ");
    if (row.kind == ParameterKind::boolean) return "true, false";
    if (row.kind == ParameterKind::text) return "text";
    const auto bound = [&](double value) {
        return row.kind == ParameterKind::integer ? std::to_string(static_cast<std::int64_t>(value))
                                                  : exact_number(value);
    };
    const std::string range = bound(row.minimum) + " to " + bound(row.maximum);
    return row.kind == ParameterKind::real_or_auto ? range + ", or auto" : range;
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t smallest = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const auto& candidate : candidates)
        if (const std::size_t d = edit_distance(word, candidate); d < smallest)
            smallest = d, best = candidate;
    return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string best = nearest(word, candidates);
    return best.empty() ? std::string() : " (did you mean '" + best + "'?)";
}

Values::Values(std::string section, std::vector<ParameterRow> rows)
    : section_(std::move(section)), rows_(std::move(rows)) {
    std::set<std::string_view> keys;
    for (const auto& row : rows_)
        if (!keys.insert(row.key).second)
            throw InputError(section_ + "." + row.key +
                             " is a key of its own; a parameter of a formula cannot have this name");
    for (const auto& row : rows_) values_.push_back(row.default_value);
    for (const auto& row : rows_) set(row.key, row.default_value); // checks that the default is in range
}

std::vector<ParameterRow> as_details(std::vector<ParameterRow> rows) {
    for (ParameterRow& row : rows) row.detail = true;
    return rows;
}

std::vector<ParameterRow> as_details(std::vector<ParameterRow> rows, std::span<const std::string_view> keys) {
    for (ParameterRow& row : rows)
        row.detail = row.detail || std::find(keys.begin(), keys.end(), row.key) != keys.end();
    return rows;
}

std::vector<ParameterRow> without_ranges(std::vector<ParameterRow> rows) {
    for (ParameterRow& row : rows)
        if (row.kind == ParameterKind::real) {
            row.minimum = -std::numeric_limits<double>::infinity();
            row.maximum = std::numeric_limits<double>::infinity();
        }
    return rows;
}

bool redefines_rows(const ParameterRow& row) {
    return row.role == ParameterRole::defines_rows || row.role == ParameterRole::formula ||
           row.role == ParameterRole::file || row.role == ParameterRole::patch;
}

const ParameterRow* find_role(const std::vector<ParameterRow>& rows, ParameterRole role) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.role == role; });
    return row == rows.end() ? nullptr : &*row;
}

std::string present_key(const std::vector<ParameterRow>& rows, std::string_view key) {
    for (const ParameterRow& row : rows)
        if (row.key == key) return row.key;
    for (const ParameterRow& row : rows)
        if (!row.former_key.empty() && row.former_key == key) return row.key;
    return {};
}

std::optional<Remedy> find_remedy(const Values& values) {
    for (const ParameterRow& row : values.rows())
        if (row.remedy && *row.remedy != values.at(row.key)) return Remedy{row.key, *row.remedy};
    return std::nullopt;
}

std::string describe(const Values& section, const Remedy& remedy) {
    return section.section() + "." + remedy.key + " = " + format_value(remedy.value);
}

bool is_default(const Values& values, std::string_view key) {
    const auto row = std::find_if(values.rows().begin(), values.rows().end(),
                                  [&](const ParameterRow& one) { return one.key == key; });
    GASPARD_CHECK(row != values.rows().end());
    return values.at(key) == row->default_value;
}

bool Values::has(std::string_view key) const {
    return std::any_of(rows_.begin(), rows_.end(), [&](const auto& row) { return row.key == key; });
}

std::size_t Values::index(std::string_view key) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (rows_[i].key == key) return i;
    std::vector<std::string> known;
    for (const auto& row : rows_) known.push_back(section_ + "." + row.key);
    const std::string name = section_ + "." + std::string(key);
    throw InputError("unknown key " + name + did_you_mean(name, known));
}

double Values::real(std::string_view key) const {
    const auto* value = std::get_if<double>(&at(key));
    GASPARD_CHECK(value != nullptr);
    return *value;
}

std::optional<double> Values::real_or_auto(std::string_view key) const {
    if (std::holds_alternative<std::string>(at(key))) return std::nullopt;
    return real(key);
}

std::int64_t Values::integer(std::string_view key) const {
    const auto* value = std::get_if<std::int64_t>(&at(key));
    GASPARD_CHECK(value != nullptr);
    return *value;
}

bool Values::boolean(std::string_view key) const {
    const auto* value = std::get_if<bool>(&at(key));
    GASPARD_CHECK(value != nullptr);
    return *value;
}

const std::string& Values::text(std::string_view key) const {
    const auto* value = std::get_if<std::string>(&at(key));
    GASPARD_CHECK(value != nullptr);
    return *value;
}

const Value& Values::at(std::string_view key) const { return values_[index(key)]; }

void Values::set(std::string_view key, const Value& value) {
    const std::size_t i = index(key);
    const ParameterRow& row = rows_[i];
    const std::string name = section_ + "." + row.key;
    const auto wrong_kind = [&] {
        throw InputError(name + " must be " + kind_name(row.kind) + ", not '" + written_value(value) + "'");
    };
    switch (row.kind) {
    case ParameterKind::real_or_auto:
    case ParameterKind::real: {
        if (row.kind == ParameterKind::real_or_auto && value == Value(std::string("auto"))) break;
        double real = 0;
        if (const auto* given = std::get_if<double>(&value))
            real = *given;
        else if (const auto* whole = std::get_if<std::int64_t>(&value))
            real = static_cast<double>(*whole);
        else
            wrong_kind();
        check_range(name, row, real);
        values_[i] = real;
        return;
    }
    case ParameterKind::integer: {
        const auto* whole = std::get_if<std::int64_t>(&value);
        if (!whole) wrong_kind();
        check_range(name, row, static_cast<double>(*whole));
        break;
    }
    case ParameterKind::boolean:
        if (!std::holds_alternative<bool>(value)) wrong_kind();
        break;
    case ParameterKind::choice: {
        const auto* given = std::get_if<std::string>(&value);
        if (!given) wrong_kind();
        const std::string& word = present_choice(row, *given);
        if (std::find(row.choices.begin(), row.choices.end(), word) == row.choices.end())
            throw InputError(name + " = '" + word + "' is unknown" + did_you_mean(word, row.choices) +
                             "; allowed: " + describe_range(row));
        values_[i] = word;
        return;
    }
    case ParameterKind::text:
        if (const auto* whole = std::get_if<std::int64_t>(&value);
            whole && row.role == ParameterRole::patch) {
            values_[i] = std::to_string(*whole);
            return;
        }
        if (!std::holds_alternative<std::string>(value)) wrong_kind();
        break;
    }
    values_[i] = value;
}

void Values::parse(std::string_view key, std::string_view text) {
    const ParameterRow& row = rows_[index(key)];
    const auto refuse_large = [&] {
        throw InputError(section_ + "." + row.key + " = " + std::string(text.substr(0, 40)) +
                         " is out of range: " + describe_range(row));
    };
    if (row.kind == ParameterKind::real || row.kind == ParameterKind::real_or_auto) {
        double real = 0;
        const Reading reading = read_all(text, real);
        if (reading == Reading::too_large) refuse_large();
        if (reading == Reading::number) return set(key, real);
    } else if (row.kind == ParameterKind::integer) {
        std::int64_t whole = 0;
        const Reading reading = read_all(text, whole);
        if (reading == Reading::too_large) refuse_large();
        if (reading == Reading::number) return set(key, whole);
    } else if (row.kind == ParameterKind::boolean) {
        if (text == "true" || text == "false") return set(key, text == "true");
    }
    set(key, std::string(text));
}

} // namespace gaspard
