#include "core/session/study_axis.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/number_text.hpp"
#include "core/scenario/clock.hpp"
#include "core/scenario/time_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t most_values = 1000;

const Values* values_of(const Scenario& scenario, std::string_view key) {
    const auto has_key = [key](const Values& values) {
        const std::string& name = values.section();
        const bool inside = key.size() > name.size() && key.starts_with(name) && key[name.size()] == '.';
        return inside && values.has(key.substr(name.size() + 1));
    };
    for (const Section* section :
         {&scenario.source, &scenario.domain, &scenario.monitor, &scenario.method, &scenario.pde})
        if (!section->type.empty() && has_key(section->values)) return &section->values;
    return has_key(scenario.time) && key != "time.speed" ? &scenario.time : nullptr;
}

/// The rule that a key of time belongs to; empty: all of them.
std::string_view rule_of(std::string_view key) {
    if (key == "time.factor") return time_rule::equidistribution;
    if (key == "time.tolerance") return time_rule::tolerance;
    return key == "time.tau" ? time_rule::relaxation : "";
}

bool is_number(const ParameterRow& row) {
    return row.kind == ParameterKind::real || row.kind == ParameterKind::real_or_auto ||
           row.kind == ParameterKind::integer;
}

bool is_type(const std::string& key) { return key.ends_with(".type"); }

/// The nearest number with so many significant digits.
double rounded(double number, int digits) {
    char text[40];
    const auto end =
        std::to_chars(text, text + sizeof text, number, std::chars_format::scientific, digits - 1).ptr;
    return parse_number({text, static_cast<std::size_t>(end - text)}).value_or(number);
}

/// What "8:1024" and "0.1:0.9:9" mean for a row.
class Range {
  public:
    Range(const ParameterRow& row, std::string_view text, const std::string& option)
        : row_(row), text_(text), option_(option), parts_(split(text, ":")) {
        if (parts_.size() < 2 || parts_.size() > 3) refuse("must be FIRST:LAST or FIRST:LAST:COUNT");
        first_ = end_at(0), last_ = end_at(1);
        if (first_ == last_) refuse("is a single value");
    }
    std::vector<Value> values() const {
        std::vector<Value> all;
        for (const double number : parts_.size() == 3 ? evenly(count()) : by_factors())
            all.push_back(whole() ? Value(static_cast<std::int64_t>(number)) : Value(number));
        return all;
    }

  private:
    [[noreturn]] void refuse(const std::string& why) const {
        throw InputError(option_ + ": the range '" + std::string(text_) + "' " + why);
    }
    double end_at(std::size_t place) const {
        const auto number = parse_number(parts_[place]);
        if (!number) refuse("must be of numbers, such as 8:1024");
        if (*number < row_.minimum || *number > row_.maximum) refuse("is not within " + describe_range(row_));
        return *number;
    }
    std::size_t count() const {
        const auto number = parse_number(parts_[2]);
        if (!number || *number != std::floor(*number) || *number < 2 ||
            *number > static_cast<double>(most_values))
            refuse("must end with a number of values from 2 to " + std::to_string(most_values));
        return static_cast<std::size_t>(*number);
    }
    bool whole() const { return row_.kind == ParameterKind::integer; }
    bool positive() const { return first_ > 0 && last_ > 0; }
    std::vector<double> by_factors() const {
        const bool logarithmic = whole() || row_.scale == ParameterScale::logarithmic;
        if (!logarithmic || !positive())
            refuse("needs a number of values, such as " + std::string(text_) + ":9");
        const double factor = whole() ? 2 : 10, step = first_ < last_ ? factor : 1 / factor;
        const double reached = std::abs(std::log(last_ / first_)) * (1 + 1e-9);
        std::vector<double> all;
        for (double at = first_; std::abs(std::log(at / first_)) <= reached && all.size() < most_values;
             at = rounded(at * step, 12)) // 1e-3, not 1.0000000000000002e-3
            all.push_back(whole() ? std::floor(at) : at);
        return all;
    }
    std::vector<double> evenly(std::size_t count) const {
        const bool logarithmic = positive() && (whole() || row_.scale == ParameterScale::logarithmic);
        std::vector<double> all;
        for (std::size_t i = 0; i < count; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(count - 1);
            const double at = i == 0           ? first_
                              : i + 1 == count ? last_
                              : logarithmic    ? rounded(first_ * std::pow(last_ / first_, t), 4)
                                               : rounded(first_ + t * (last_ - first_), 12);
            const double number = whole() ? std::round(at) : at;
            if (all.empty() || all.back() != number) all.push_back(number);
        }
        return all;
    }

    const ParameterRow& row_;
    std::string_view text_;
    const std::string& option_;
    std::vector<std::string_view> parts_;
    double first_ = 0, last_ = 0;
};

/// The value as it is written when it is set; throws InputError if it is not allowed.
std::string allowed(const Catalogue& catalogue, const Scenario& scenario, const std::string& key,
                    const ParameterRow* row, std::string_view text) {
    if (!row) { // a type
        Scenario changed = scenario;
        set_value(catalogue, changed, key, std::string(text));
        return std::string(text);
    }
    Values values = *values_of(scenario, key);
    values.parse(row->key, text);
    return format_value(values.at(row->key));
}

const ParameterRow* row_to_vary(const Catalogue& catalogue, const Scenario& scenario, const std::string& key,
                                const std::string& option) {
    Scenario copy = scenario;
    check_key(catalogue, copy, key);
    const ParameterRow* row = study_row(scenario, key);
    if (!row && !is_type(key)) throw InputError(option + ": " + key + " does not change what is solved");
    if (row && row->kind == ParameterKind::text)
        throw InputError(option + ": " + key + " is a text; a study varies numbers, choices and types");
    return row;
}

} // namespace

const ParameterRow* study_row(const Scenario& scenario, std::string_view key) {
    const Values* values = values_of(scenario, key);
    if (!values) return nullptr;
    const auto& rows = values->rows();
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const ParameterRow& one) {
        return key.size() == values->section().size() + 1 + one.key.size() && key.ends_with(one.key);
    });
    return row == rows.end() ? nullptr : &*row;
}

std::string why_without_effect(const Scenario& scenario, std::string_view key) {
    const Values& time = scenario.time;
    if (key.starts_with("time.")) {
        if (!has_time(time) && key != "time.start" && key != "time.end")
            return std::string(key) + " has no effect: no time passes unless time.end is after time.start";
        const std::string_view rule = rule_of(key);
        if (!rule.empty() && rule != time.text("rule"))
            return std::string(key) + " has no effect unless time.rule is " + std::string(rule);
        return {};
    }
    if (!has_time(time) || !key.starts_with("monitor.")) return {};
    const std::string_view own = key.substr(std::string_view("monitor.").size());
    return Clock(scenario).why_unused(own);
}

StudyAxis parse_study_axis(const Catalogue& catalogue, const Scenario& scenario, std::string_view text,
                           const std::string& option) {
    const auto equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == text.size())
        throw InputError(option + " must be KEY=VALUES, such as domain.cells=8,16,32, not '" +
                         std::string(text) + "'");
    StudyAxis axis{.key = std::string(text.substr(0, equals))};
    const ParameterRow* row = row_to_vary(catalogue, scenario, axis.key, option);
    for (const std::string_view part : split(text.substr(equals + 1), ",")) {
        if (row && is_number(*row) && part.find(':') != std::string_view::npos)
            for (const Value& number : Range(*row, part, option).values())
                axis.values.push_back(format_value(number));
        else
            axis.values.push_back(allowed(catalogue, scenario, axis.key, row, part));
        if (axis.values.size() > most_values)
            throw InputError(option + " has more than " + std::to_string(most_values) + " values");
    }
    std::vector<std::string> sorted = axis.values;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
        throw InputError(option + " names " + *twice + " twice");
    return axis;
}

StudyAxis parse_study_numbers(const Catalogue& catalogue, const Scenario& scenario, std::string_view text,
                              const std::string& option) {
    StudyAxis axis = parse_study_axis(catalogue, scenario, text, option);
    std::vector<std::pair<double, std::string>> numbers;
    for (const std::string& value : axis.values) {
        const auto number = parse_number(value);
        if (!number)
            throw InputError(option + ": " + axis.key + " must be numbers, not '" + value +
                             "'; --lines takes other values");
        numbers.emplace_back(*number, value);
    }
    std::sort(numbers.begin(), numbers.end());
    axis.values.clear();
    for (auto& one : numbers) axis.values.push_back(std::move(one.second));
    return axis;
}

} // namespace gaspard
