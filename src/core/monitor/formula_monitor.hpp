// Monitors from typed formulas: m(x) = formula(x) (function/formula.hpp).
#pragma once

#include "core/base/export.hpp"
#include "core/function/formula.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <string>

namespace gaspard GASPARD_API {

/// m(x) = formula(x), in the coordinates of options.space, which must be that of the run (Run::space).
/// values() throws InputError with the position if the formula is not positive or not finite. Throws
/// ExpressionError if the text is not a formula, and InputError if a parameter has no value or a value no
/// parameter.
std::shared_ptr<const Monitor> formula_monitor(const std::string& text, FormulaOptions options = {});

} // namespace GASPARD_API
