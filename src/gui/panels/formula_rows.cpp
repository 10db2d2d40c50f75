#include "gui/panels/formula_rows.hpp"

#include "core/base/error.hpp"
#include "core/function/formula.hpp"
#include "gui/panels/sections.hpp"

namespace gaspard {

namespace {

/// A message without the key that it begins with: the field says which one it is about.
std::string without_key(const std::string& message, const std::string& key) {
    return message.starts_with(key + ": ") ? message.substr(key.size() + 2) : message;
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

std::vector<FormulaWord> formula_words(const Catalogue& catalogue, const Scenario& scenario) {
    std::vector<FormulaWord> words;
    for (const FormulaName& one : formula_names(space_of(catalogue, scenario)))
        words.push_back({one.name, one.help, one.name.find('(') != std::string::npos});
    return words;
}

} // namespace gaspard
