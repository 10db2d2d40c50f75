// Rows whose value is a formula: what is wrong with a text, and what it may contain.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "gui/panels/formula_field.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// Whether the value of a row is a formula.
bool is_formula(const ParameterRow& row);

/// What is wrong with `text` as the formula of a row of a scenario; nothing if it can be applied. Takes less
/// than a millisecond.
std::optional<FormulaComplaint> formula_complaint(const Catalogue& catalogue, const Scenario& scenario,
                                                  const std::string& section, const std::string& row,
                                                  const std::string& text);

/// Whether the value of a row says how the monitor moves: a formula in t, or a path.
bool is_motion(const Values& values, const ParameterRow& row);
/// What is wrong with `text` as the motion of a row of the section "time". Takes some milliseconds: values
/// are checked at a hundred times, those in between by the solver. Rows are called by their labels.
std::optional<FormulaComplaint> motion_complaint(const Scenario& scenario, const std::string& row,
                                                 const std::string& text);

/// The functions and variables that formulas of a scenario may use.
std::vector<FormulaWord> formula_words(const Catalogue& catalogue, const Scenario& scenario);

} // namespace gaspard
