#include "gui/panels/formula_rows.hpp"

#include "core/base/error.hpp"
#include "core/function/expression.hpp"
#include "core/function/formula.hpp"
#include "core/scenario/clock.hpp"
#include "core/scenario/time_rows.hpp"
#include "gui/panels/sections.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

/// A message without the key that it begins with: the field says which one it is about.
std::string without_key(const std::string& message, const std::string& key) {
    return message.starts_with(key + ": ") ? message.substr(key.size() + 2) : message;
}

/// A message in which rows have the labels of the window, not their keys: "Path and Centre x(t) both ...".
std::string with_labels(const std::string& message, const Scenario& scenario) {
    const auto in_key = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
    };
    std::string text;
    for (std::size_t i = 0; i < message.size();) {
        std::size_t end = i;
        while (end < message.size() && in_key(message[end])) ++end;
        std::string word = message.substr(i, std::max<std::size_t>(end - i, 1));
        i += word.size();
        for (const Values* values : {&scenario.time, &scenario.monitor.values})
            for (const ParameterRow& row : values->rows())
                if (word == values->section() + "." + row.key) word = row.label;
        text += word;
    }
    return text;
}

} // namespace

bool is_formula(const ParameterRow& row) { return row.role == ParameterRole::formula; }

std::optional<FormulaComplaint> formula_complaint(const Catalogue& catalogue, const Scenario& scenario,
                                                  const std::string& section, const std::string& row,
                                                  const std::string& text) {
    try {
        check_formula(text, space_of(catalogue, scenario));
        Scenario candidate = scenario;
        for (const auto kind : all_sections)
            if (section_key(kind) == section) section_of(candidate, kind).values.set(row, text);
        update_rows(catalogue, candidate);
        return std::nullopt;
    } catch (const ExpressionError& error) {
        return FormulaComplaint{error.what(), error.character()};
    } catch (const InputError& error) {
        return FormulaComplaint{without_key(error.what(), section + "." + row), {}};
    }
}

bool is_motion(const Values& values, const ParameterRow& row) {
    return values.section() == "time" && (row.role == ParameterRole::motion || row.key == "path");
}

std::optional<FormulaComplaint> motion_complaint(const Scenario& scenario, const std::string& row,
                                                 const std::string& text) {
    try {
        if (row != "path" && !text.empty()) Expression(text, Space{}); // says where it is wrong
        Scenario candidate = scenario;
        Values& time = candidate.time;
        time.set(row, text);
        if (!has_time(time)) time.set("end", time.real("start") + time.real("step")); // so far it can be said
        Clock(std::move(candidate), 100);
        return std::nullopt;
    } catch (const ExpressionError& error) {
        return FormulaComplaint{error.what(), error.character()};
    } catch (const InputError& error) {
        return FormulaComplaint{with_labels(without_key(error.what(), "time." + row), scenario), {}};
    }
}

std::vector<FormulaWord> formula_words(const Catalogue& catalogue, const Scenario& scenario) {
    std::vector<FormulaWord> words;
    for (const FormulaName& one : formula_names(space_of(catalogue, scenario)))
        words.push_back({one.name, one.help, one.name.find('(') != std::string::npos});
    return words;
}

} // namespace gaspard
